/// Values of the macro language. A number written with a decimal point is real; integers stay whole, and their quotient
/// is whole, too.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace syntec {

/// The whole numbers of the control, which has 32 bits for them.
inline constexpr double smallest_whole = -2147483648.0, largest_whole = 2147483647;
inline bool is_of_32_bits(double n) { return n >= smallest_whole && n <= largest_whole && n == std::trunc(n); }

struct MacroValue {
  enum class Kind : std::uint8_t { vacant, whole, real, text };
  Kind kind = Kind::vacant;
  double number = 0;
  std::string text{};  ///< of VACANT: the variable that had no value, for the report

  static MacroValue whole(double n) { return {Kind::whole, n}; }
  static MacroValue real(double n) { return {Kind::real, n}; }
  /// Whole where 32 bits hold it: a number that a table or a program in ISO format gives.
  static MacroValue of_number(double n) { return is_of_32_bits(n) ? whole(n + 0.0) : real(n); }
  static MacroValue of_truth(bool holds) { return whole(holds ? 1 : 0); }
  static MacroValue of_text(std::string t) { return {Kind::text, 0, std::move(t)}; }

  bool is_vacant() const { return kind == Kind::vacant; }
  bool is_whole() const { return kind == Kind::whole; }
  bool is_text() const { return kind == Kind::text; }
  bool is_number() const { return kind == Kind::whole || kind == Kind::real; }
  /// For whoever shows variables; NaN: it has no number.
  double shown() const { return is_number() ? number : std::numeric_limits<double>::quiet_NaN(); }
};

}  // namespace syntec
