#include "tool_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "isogloss/engine/chain.hpp"

namespace isogloss::cli {

Point PathArc::at(double angle) const {
  Point out;
  const double part = sweep == 0 ? 0 : angle / sweep;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = center[i] + r[i] * std::cos(angle) + q[i] * std::sin(angle) + rise[i] * part;
  return out;
}

double PathArc::radius() const { return std::hypot(r[0], r[1], r[2]); }

void Extent::add(const Point& p) {
  for (std::size_t i = 0; i < 3; ++i) {
    minimum[i] = is_empty ? p[i] : std::min(minimum[i], p[i]);
    maximum[i] = is_empty ? p[i] : std::max(maximum[i], p[i]);
  }
  is_empty = false;
}

void Extent::add(const PathArc& arc) {
  constexpr double turn = 2 * std::numbers::pi;
  const double low = std::min(0.0, arc.sweep), high = std::max(0.0, arc.sweep);
  add(arc.at(0));
  add(arc.at(arc.sweep));
  for (std::size_t i = 0; i < 3; ++i) {
    // The turning points of this axis: radius·cos(φ + shift) = -rise/sweep.
    const double radius = std::hypot(arc.r[i], arc.q[i]);
    const double slope = arc.sweep == 0 ? 0 : arc.rise[i] / arc.sweep;
    if (radius <= std::abs(slope)) continue;
    const double shift = std::atan2(arc.r[i], arc.q[i]), half = std::acos(-slope / radius);
    for (const double root : {half - shift, -half - shift}) {
      // Turn after turn they shift by the same amount: the first and the last tell.
      const double first = root + turn * std::ceil((low - root) / turn);
      if (first > high) continue;
      add(arc.at(first));
      add(arc.at(root + turn * std::floor((high - root) / turn)));
    }
  }
}

}  // namespace isogloss::cli
