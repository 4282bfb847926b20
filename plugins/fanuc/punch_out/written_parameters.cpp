#include "punch_out/written_parameters.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include <isogloss/cnc/units.hpp>

#include "punch_out/punched_block.hpp"
#include "punch_out/punched_parameters.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

constexpr const char *parameters = "FanucParameterTable", *work_offsets = "IsoCoordinateTable";
constexpr std::string_view axis_columns = "XYZABC";
constexpr std::int64_t external_offset = 1220, increment_system = 1013;

class ParameterWriter {
 public:
  ParameterWriter(ig::Export& out, const WrittenParameters& how) : out_(out), how_(how) {}

  void write() {
    for (std::uint32_t row = 0; row < out_.rows(parameters); ++row) add_parameter(row);
    for (std::uint32_t row = 0; row < out_.rows(work_offsets); ++row) add_work_offset(row);
    out_.write("%\n");
    for (const auto& [number, values] : blocks_) {
      const std::string digits = std::to_string(number);
      out_.write("N" + std::string(5 - digits.size(), '0') + digits + "Q1" + values + "\n");
    }
    out_.write("%\n");
  }

 private:
  /// The number of a cell; nothing where it holds none, or one that is too large for a control.
  std::optional<double> number_of(const char* table, std::uint32_t row, std::string_view column) {
    constexpr double largest = 1e9;
    const std::string_view text = out_.cell(table, row, column);
    if (text.empty()) return std::nullopt;
    const ig::Decimal n = ig::read_decimal(text, 0);
    if (n.ok && n.end == text.size() && std::abs(n.value) <= largest) return n.value;
    out_.unused("column " + std::string(column), "it holds no number that a parameter takes");
    return std::nullopt;
  }

  void add_parameter(std::uint32_t row) {
    const std::string_view key = out_.key(parameters, row);
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
    const KnownParameter* const known =
        error == std::errc{} && end == key.data() + key.size() ? known_parameter(number) : nullptr;
    if (known == nullptr || known->kind == ParameterKind::work_offset)
      return out_.unused("parameter " + std::string(key), "the form of its value is not known");
    if (known->has_axes) return add_axes(parameters, row, number, *known);
    for (const char axis : axis_columns)
      if (!out_.cell(parameters, row, {&axis, 1}).empty())
        out_.unused("value of an axis of parameter " + std::string(key), "it has one value, in the column Value");
    if (const std::optional<double> value = number_of(parameters, row, "Value"))
      if (const std::string text = text_of(*known, *value, 0); !text.empty())
        // The table has the increment system of the first axis alone.
        add(number, number == increment_system ? "A1" : "L" + std::to_string(how_.path), text);
  }

  void add_work_offset(std::uint32_t row) {
    constexpr std::string_view names[] = {"EXT", "G54", "G55", "G56", "G57", "G58", "G59"};
    const auto name = std::find(std::begin(names), std::end(names), out_.key(work_offsets, row));
    if (name == std::end(names))
      return out_.unused("work offset " + std::string(out_.key(work_offsets, row)), "parameters hold EXT, G54 to G59");
    const std::int64_t number = external_offset + (name - std::begin(names));
    add_axes(work_offsets, row, number, *known_parameter(number));
  }

  void add_axes(const char* table, std::uint32_t row, std::int64_t number, const KnownParameter& known) {
    if (table == parameters && !out_.cell(table, row, "Value").empty())
      out_.unused("value of parameter " + std::to_string(number), "it has a value for each axis");
    for (std::size_t axis = 0; axis < how_.axes.size(); ++axis) {
      const char letter = how_.axes[axis];
      if (axis_columns.find(letter) == std::string_view::npos || how_.axes.find(letter) != axis) continue;
      if (const std::optional<double> value = number_of(table, row, {&letter, 1}))
        add(number, "A" + std::to_string(axis + 1), text_of(known, *value, letter));
    }
    for (const char letter : axis_columns)
      if (how_.axes.find(letter) == std::string_view::npos && !out_.cell(table, row, {&letter, 1}).empty())
        out_.unused(std::string("value of axis ") + letter, "option axes gives this axis no number");
  }

  void add(std::int64_t number, const std::string& holder, const std::string& text) {
    if (!text.empty()) blocks_[number] += holder + text;
  }

  /// The value with its letter; empty, and named, where the control has no such value. A length has the letter of its
  /// unit, so that the file means the same on each control.
  std::string text_of(const KnownParameter& known, double value, char axis) {
    const double per_length = how_.is_inch ? mm_per_inch : 1;
    const auto length = [&](double mm) {
      return (how_.is_inch ? "I" : "M") + punched_number(rounded(mm / per_length));
    };
    switch (known.kind) {
      case ParameterKind::bits: return bits_text(value);
      case ParameterKind::number: return "P" + fixed_text(value);
      case ParameterKind::counted: return length(value / counts_per_mm_);
      case ParameterKind::counted_angle: return "P" + punched_number(rounded(value / counts_per_mm_));
      case ParameterKind::position:
      case ParameterKind::rate:
      case ParameterKind::work_offset: return is_rotary(axis) ? "M" + punched_number(rounded(value)) : length(value);
    }
    return {};
  }

  std::string bits_text(double value) {
    const std::optional<std::int64_t> whole = whole_number(value);
    if (!whole || *whole < 0 || *whole > 255) {
      out_.unused("value of bits", "it is no whole number from 0 to 255");
      return {};
    }
    std::string text = "P";
    for (int bit = 7; bit >= 0; --bit) text += (*whole >> bit & 1) != 0 ? '1' : '0';
    return text;
  }

  static double rounded(double value) {
    constexpr double steps = 1e6;  // finer than any control
    return std::round(value * steps) / steps;
  }

  double counts_per_mm() const {
    for (std::uint32_t row = 0; row < out_.rows(parameters); ++row) {
      if (out_.key(parameters, row) != std::to_string(increment_system)) continue;
      const auto bits = static_cast<unsigned>(
          whole_number(ig::read_decimal(out_.cell(parameters, row, "Value"), 0).value).value_or(0));
      return (bits & 1u) != 0 ? 100 : (bits & 2u) != 0 ? 10000 : 1000;
    }
    return 1000;
  }

  ig::Export& out_;
  const WrittenParameters& how_;
  const double counts_per_mm_ = counts_per_mm();
  std::map<std::int64_t, std::string> blocks_;  // by number: the values
};

}  // namespace

void write_parameters(ig::Export& out, const WrittenParameters& how) { ParameterWriter(out, how).write(); }

}  // namespace fanuc
