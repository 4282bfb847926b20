/// What a frame does to circles.
#pragma once

#include <cmath>
#include <initializer_list>
#include <span>

#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/tilt_transform.hpp>

namespace siemens {

using namespace ig::cnc;

/// The direction in which the frame maps an axis of the program; its length is the scale of the axis.
inline ig::Vec3 axis_of(std::span<const double, 16> m, std::size_t axis) {
  return {m[4 * axis], m[4 * axis + 1], m[4 * axis + 2]};
}

/// True where a circle in the plane remains a circle: both axes have the same scale and are square to each other.
inline bool keeps_circles(std::span<const double, 16> m, const PlaneAxes& plane) {
  const ig::Vec3 u = axis_of(m, plane.first), v = axis_of(m, plane.second);
  const double size = length(u);
  const double skew = u.x * v.x + u.y * v.y + u.z * v.z;
  return std::fabs(length(v) - size) <= 1e-9 * size && std::fabs(skew) <= 1e-9 * size * size;
}

/// The entries of the frame one after the other; those that are not set change nothing.
inline Mat4 chained(const ig::Block& b, std::initializer_list<const ig::Transform*> entries) {
  Mat4 m = identity_frame, next;
  for (const ig::Transform* entry : entries)
    if (b.get(*entry, next)) m = product(m, next);
  return m;
}

}  // namespace siemens
