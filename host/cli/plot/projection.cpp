#include "plot/projection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isogloss::cli::plotting {

void Projection::fit(const Extent& extent, const Frame& frame) {
  frame_ = frame;
  scale_ = 1;
  origin_ = {};
  Spot low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
  for (unsigned corner = 0; corner < 8; ++corner) {
    Point p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = (corner >> i & 1u) != 0 ? extent.maximum[i] : extent.minimum[i];
    const Spot s = at(p);
    low = {std::min(low.x, s.x), std::min(low.y, s.y)};
    high = {std::max(high.x, s.x), std::max(high.y, s.y)};
  }
  constexpr double least_mm = 1e-3;
  const double width = std::max(high.x - low.x, least_mm), height = std::max(high.y - low.y, least_mm);
  scale_ = std::min(frame.width / width, frame.height / height);
  origin_ = {frame.x + frame.width / 2 - scale_ * (low.x + high.x) / 2,
             frame.y + frame.height / 2 - scale_ * (low.y + high.y) / 2};
}

Ellipse project(const Projection& projection, const PathArc& arc) {
  // The circle is M (cos φ, sin φ); the singular values of M are the half axes.
  const Spot r = projection.vector(arc.r), q = projection.vector(arc.q);
  const double a = r.x * r.x + q.x * q.x, d = r.y * r.y + q.y * q.y, b = r.x * r.y + q.x * q.y;
  const double middle = (a + d) / 2, spread = std::hypot((a - d) / 2, b);
  Ellipse out;
  out.major = std::sqrt(middle + spread);
  const double determinant = r.x * q.y - q.x * r.y;
  out.minor = out.major > 0 ? std::abs(determinant) / out.major : 0;
  out.tilt_deg = std::atan2(2 * b, a - d) / 2 * 180 / std::numbers::pi;
  out.is_clockwise = determinant > 0;
  return out;
}

}  // namespace isogloss::cli::plotting
