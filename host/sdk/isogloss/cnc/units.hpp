/// Factors between the units of programs and those of the block document (mm, degrees).
#pragma once

#include <numbers>

namespace ig::cnc {

/// Multiply by the factor to get the unit named first.
inline constexpr double mm_per_inch = 25.4;
inline constexpr double radians_per_degree = std::numbers::pi / 180;
inline constexpr double degrees_per_radian = 180 / std::numbers::pi;

}  // namespace ig::cnc
