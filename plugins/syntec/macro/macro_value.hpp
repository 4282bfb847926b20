/// Values of the macro language. A number written with a decimal point is real; integers stay whole, and their quotient
/// is whole, too.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace syntec {

struct MacroValue {
  enum class Kind : std::uint8_t { vacant, whole, real, text };
  Kind kind = Kind::vacant;
  double number = 0;
  std::string text{};

  static MacroValue whole(double n) { return {Kind::whole, n}; }
  static MacroValue real(double n) { return {Kind::real, n}; }
  static MacroValue of_truth(bool holds) { return whole(holds ? 1 : 0); }
  static MacroValue of_text(std::string t) { return {Kind::text, 0, std::move(t)}; }

  bool is_vacant() const { return kind == Kind::vacant; }
  bool is_whole() const { return kind == Kind::whole; }
  bool is_text() const { return kind == Kind::text; }
  bool is_number() const { return kind == Kind::whole || kind == Kind::real; }
  /// For whoever shows variables; NaN: it has no number.
  double shown() const { return is_number() ? number : std::numeric_limits<double>::quiet_NaN(); }
};

/// The largest whole number of the control, which has 32 bits for it.
inline constexpr double largest_whole = 2147483647;

}  // namespace syntec
