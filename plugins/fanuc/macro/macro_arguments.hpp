/// Arguments of a macro call: the local variable of each address, and the unit of a number without a decimal point.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include <isogloss/sdk.hpp>

namespace fanuc {

/// The local variable of each address, A to Z; 0: the address is not an argument.
inline constexpr std::array<std::uint8_t, 26> variable_of{1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                                          0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

/// A member of each syntax that passes arguments.
class ArgumentUnits {
 public:
  /// The value of a number without a point: lengths and angles are in increments, unless the control is set otherwise.
  double counted(ig::Block& b, char letter, double number, std::size_t begin, std::size_t end) const {
    if (number == 0 || std::string_view("ABCIJKQRUVWXYZ").find(letter) == std::string_view::npos) return number;
    double value = number;
    if (number_format_.number("CalculatorDecimalPoint").value_or(1) == 0) {
      const bool is_angle = letter >= 'A' && letter <= 'C';
      const bool is_inch = !is_angle && b.is(system_, inch_);
      const double increment = number_format_
                                   .number(is_angle  ? "AngleIncrement_deg"
                                           : is_inch ? "LengthIncrement_inch"
                                                     : "LengthIncrement_mm")
                                   .value_or(is_inch ? 0.0001 : 0.001);
      value = number / std::round(1 / increment);
    }
    b.report(ig::diag("FAN-0166"), ig::Where::columns(begin, end), std::string_view(&letter, 1), number, value);
    return value;
  }

 private:
  ig::Config number_format_{"isogloss.number-format/1", ig::Need::optional, "What arguments without a point count."};
  ig::In<ig::Symbol> system_{"Unit.System"};
  ig::Name inch_{"Inch"};
};

}  // namespace fanuc
