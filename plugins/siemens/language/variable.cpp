// Conversion of values, and the numbering of the elements of an array.
#include "language/variable.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace siemens {

namespace {

std::string shown(double number) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

}  // namespace

Value Declared::initial() const { return {lowest > 0 ? lowest : highest < 0 ? highest : 0, type, {}}; }

Stored Declared::fit(Value& value) const {
  if (type == Type::frame || value.type == Type::frame) return type == value.type ? Stored::yes : Stored::wrong_type;
  if (type == Type::text) {
    if (value.type != Type::text) return Stored::wrong_type;
    if (length > 0 && value.text.size() > length) {
      if (!cuts) return Stored::too_long;
      value.text.resize(length);
    }
    return Stored::yes;
  }
  double number = value.number;
  if (value.type == Type::text) {  // manual Job planning, "Possible type conversions"
    if (type == Type::boolean)
      number = value.text.empty() ? 0 : 1;
    else if (detail == Detail::character && value.text.size() == 1)
      number = static_cast<unsigned char>(value.text[0]);
    else
      return Stored::wrong_type;
  }
  if (type == Type::integer) number = std::round(number);
  if (type == Type::boolean) number = number != 0 ? 1 : 0;
  if (!(number >= lowest && number <= highest) || !std::isfinite(number)) return Stored::out_of_range;
  value = {number, type, {}};
  return Stored::yes;
}

std::string Declared::range() const {
  if (std::isinf(lowest)) return "up to " + shown(highest);
  return std::isinf(highest) ? "from " + shown(lowest) : shown(lowest) + " to " + shown(highest);
}

std::optional<std::size_t> Variable::number_of(std::string_view indices) const {
  const std::size_t count = std::max<std::size_t>(sizes.size(), 1);
  std::size_t number = 0, next = 1;
  for (std::size_t i = 0; i < count && next < indices.size(); ++i) {
    std::uint32_t index = 0;
    const auto [end, error] = std::from_chars(indices.data() + next, indices.data() + indices.size(), index);
    if (error != std::errc{} || (!sizes.empty() && index >= sizes[i])) return std::nullopt;
    next = static_cast<std::size_t>(end - indices.data());
    if (next >= indices.size() || indices[next] != (i + 1 < count ? ',' : ']')) return std::nullopt;
    ++next;
    number = sizes.empty() ? index : number * sizes[i] + index;
  }
  return next == indices.size() ? std::optional(number) : std::nullopt;
}

std::string Variable::indices_of(std::size_t number) const {
  std::string out = "]";
  for (std::size_t i = sizes.size(); i-- > 0; number /= sizes[i])
    out.insert(0, (i == 0 ? "[" : ",") + std::to_string(number % sizes[i]));
  return sizes.empty() ? "[" + std::to_string(number) + "]" : out;
}

std::size_t Variable::size() const {
  std::size_t n = 1;
  for (const std::uint32_t s : sizes) n *= s;
  return n;
}

std::string Variable::shown_as(std::string_view name) const {
  std::string out(name);
  if (sizes.empty()) return out + "[]";
  for (std::size_t i = 0; i < sizes.size(); ++i) out += (i == 0 ? '[' : ',') + std::to_string(sizes[i]);
  return out + ']';
}

}  // namespace siemens
