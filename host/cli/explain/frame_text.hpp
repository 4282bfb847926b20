/// A transform in words instead of sixteen numbers: what it adds, turns, mirrors or scales.
#pragma once

#include <array>
#include <string>

namespace isogloss::cli {

/// Millimetres and degrees without trailing zeros; never "-0".
std::string short_number(double value);
/// "X10 Z-5", of those that are not zero.
std::string axis_words(const std::array<double, 3>& values);

/// What a rung of the ladder does to a point. Row vectors, translation in elements 12 to 14.
struct FrameEffect {
  bool is_shift = true;           ///< nothing but a translation
  std::array<double, 3> shift{};  ///< elements 12 to 14
  std::string text;               ///< "adds X-161.8", "turns 45° about Y", "changes nothing"
};
FrameEffect effect_of(const std::array<double, 16>& matrix);
/// The same of the JSON text of a matrix; empty where it is none.
std::string effect_of_json(const std::string& matrix);

}  // namespace isogloss::cli
