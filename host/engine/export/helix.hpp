/// The path of an arc, for its length and its extents.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isogloss {

/// A circular or helical path: center + r·cos φ + q·sin φ + rise·φ/sweep, φ from 0 to sweep (radians, about the
/// normal).
struct Helix {
  double center[3], r[3], q[3], rise[3];
  double sweep;

  Helix(const double* start, const double* end, const double* middle, const double* normal, double degrees)
      : sweep(degrees * std::numbers::pi / 180) {
    double height_of_start = 0, height = 0;
    for (int i = 0; i < 3; ++i) {
      height_of_start += (start[i] - middle[i]) * normal[i];
      height += (end[i] - start[i]) * normal[i];
    }
    for (int i = 0; i < 3; ++i) {
      center[i] = middle[i] + height_of_start * normal[i];
      r[i] = start[i] - center[i];
      rise[i] = height * normal[i];
    }
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      q[i] = normal[j] * r[k] - normal[k] * r[j];
    }
  }

  double at(unsigned axis, double angle) const {
    return center[axis] + r[axis] * std::cos(angle) + q[axis] * std::sin(angle) + rise[axis] * angle / sweep;
  }

  double length(const double* end) const {
    double start_radius = 0, end_radius = 0, height = 0;
    for (int i = 0; i < 3; ++i) {
      const double out = end[i] - rise[i] - center[i];
      start_radius += r[i] * r[i];
      end_radius += out * out;
      height += rise[i] * rise[i];
    }
    const double arc = (std::sqrt(start_radius) + std::sqrt(end_radius)) / 2 * sweep;
    return std::sqrt(arc * arc + height);
  }

  /// Calls visit(position) for the turning points of one axis between start and end.
  template <class Visit>
  void turning_points(unsigned axis, Visit visit) const {
    const double radius = std::sqrt(r[axis] * r[axis] + q[axis] * q[axis]);
    if (sweep == 0 || radius <= std::abs(rise[axis] / sweep)) return;
    // q·cos φ - r·sin φ + rise/sweep = 0, as radius·cos(φ + shift) = -rise/sweep
    const double shift = std::atan2(r[axis], q[axis]);
    const double half = std::acos(-rise[axis] / sweep / radius);
    const double low = std::min(0.0, sweep), high = std::max(0.0, sweep);
    constexpr double turn = 2 * std::numbers::pi;
    for (const double root : {half - shift, -half - shift}) {
      // Turn after turn they shift by the same amount: the first and the last tell.
      const double first = root + turn * std::ceil((low - root) / turn);
      const double last = root + turn * std::floor((high - root) / turn);
      if (first > high) continue;
      visit(at(axis, first));
      visit(at(axis, last));
    }
  }
};

}  // namespace isogloss
