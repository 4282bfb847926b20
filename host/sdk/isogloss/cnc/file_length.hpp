/// Lengths of files that importers read and write. `unit` is the file's unit in mm: 1 or mm_per_inch.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace ig::cnc {

/// In mm to a billionth: three inches are 76.2 mm and not 76.19999999999999.
inline double length_in_mm(double length, double unit) {
  constexpr double parts = 1e9;
  return unit == 1 ? length : std::round(length * unit * parts) / parts;
}
/// The reverse, so fine that length_in_mm() gives the same mm again.
inline double length_in_unit(double mm, double unit) {
  constexpr double parts = 1e12;
  return unit == 1 ? mm : std::round(mm / unit * parts) / parts;
}

/// The shortest text of a number without an exponent.
inline std::string fixed_text(double value) {
  std::array<char, 400> digits;  // room for the largest double
  char* const end = digits.data() + digits.size();
  return {digits.data(), std::to_chars(digits.data(), end, value, std::chars_format::fixed).ptr};
}

}  // namespace ig::cnc
