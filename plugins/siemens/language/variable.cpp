// Conversion of values, and the numbering of the elements of an array.
#include "language/variable.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace siemens {

std::optional<Value> Value::as(Type wanted) const {
  if (is_text() != (wanted == Type::text)) return std::nullopt;
  if (wanted == Type::integer) return integer(std::round(number));
  if (wanted == Type::boolean) return truth(number != 0);
  Value out = *this;
  out.type = wanted;
  return out;
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
