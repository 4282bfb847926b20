/// A transform in words instead of sixteen numbers: what it adds, turns, mirrors or scales.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace isogloss::cli {

/// With the resolution of the motions of a run, six decimals, without trailing zeros; never "-0".
std::string short_number(double value);
/// A JSON number so; other JSON text as it is.
std::string short_value(const std::string& json);
/// "X10 Z-5", of those that are not zero. `unit_mm`: 25.4 gives lengths in inch.
std::string axis_words(const std::array<double, 3>& values, double unit_mm = 1);

inline constexpr std::string_view changes_nothing = "changes nothing";

/// What a rung of the ladder does to a point. Row vectors, translation in elements 12 to 14.
struct FrameEffect {
  bool is_shift = true;           ///< nothing but a translation
  std::array<double, 3> shift{};  ///< elements 12 to 14
  std::string text;               ///< "adds X-161.8", "turns 45° about Y", "changes nothing"
};
FrameEffect effect_of(const std::array<double, 16>& matrix, double unit_mm = 1);
/// The same of the JSON text of a matrix; empty where it is none.
std::string effect_of_json(const std::string& matrix, double unit_mm = 1);

}  // namespace isogloss::cli
