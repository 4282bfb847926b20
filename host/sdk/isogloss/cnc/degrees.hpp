/// Sine, cosine and tangent of angles in degrees, and the angles of a sine and a cosine. Controls calculate with
/// decimal digits, and a program may ask whether SIN[30] is 0.5: where the answer has one digit, or is an angle of
/// whole degrees, it is exact here.
#pragma once

#include <cmath>
#include <limits>

#include "isogloss/cnc/units.hpp"

namespace ig::cnc {

inline double sine(double degrees) {
  const double turn = std::remainder(degrees, 360.0);  // -180 to 180
  const double a = std::abs(turn);
  const double sign = turn < 0 ? -1 : 1;
  if (a == 0 || a == 180) return 0;
  if (a == 30 || a == 150) return sign * 0.5;
  if (a == 90) return sign;
  return std::sin(turn * radians_per_degree);
}

inline double cosine(double degrees) {
  const double a = std::abs(std::remainder(degrees, 360.0));
  if (a == 0) return 1;
  if (a == 60) return 0.5;
  if (a == 90) return 0;
  if (a == 120) return -0.5;
  if (a == 180) return -1;
  return std::cos(a * radians_per_degree);
}

/// NaN at 90 degrees and at half turns from there.
inline double tangent(double degrees) {
  const double turn = std::remainder(degrees, 180.0);  // -90 to 90
  if (turn == 0) return 0;
  if (std::abs(turn) == 45) return turn < 0 ? -1 : 1;
  if (std::abs(turn) == 90) return std::numeric_limits<double>::quiet_NaN();
  return std::tan(turn * radians_per_degree);
}

/// -90 to 90; NaN where the sine is beyond -1 and 1.
inline double arc_sine(double sine) {
  if (std::abs(sine) == 0.5) return sine < 0 ? -30 : 30;
  return std::asin(sine) * degrees_per_radian;
}

/// 0 to 180; NaN where the cosine is beyond -1 and 1.
inline double arc_cosine(double cosine) {
  if (std::abs(cosine) == 0.5) return cosine < 0 ? 120 : 60;
  return std::acos(cosine) * degrees_per_radian;
}

}  // namespace ig::cnc
