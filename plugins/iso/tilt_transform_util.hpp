/// The entry TiltTransform of the frame: rotations of the programmed coordinates. Matrices as in the block document:
/// row vectors, translation in elements 12 to 14.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "plane_util.hpp"

namespace iso {

using Mat4 = std::array<double, 16>;

inline constexpr Mat4 identity_frame{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

inline ig::Vec3 mapped(const Mat4& m, const ig::Vec3& p) {
  return {p.x * m[0] + p.y * m[4] + p.z * m[8] + m[12], p.x * m[1] + p.y * m[5] + p.z * m[9] + m[13],
          p.x * m[2] + p.y * m[6] + p.z * m[10] + m[14]};
}

/// Cosine and sine; those of quarter turns are exact.
struct Turn {
  double cos = 1, sin = 0;

  static Turn by(double degrees) {
    const double angle = std::remainder(degrees, 360.0);
    if (angle == 0) return {1, 0};
    if (angle == 90) return {0, 1};
    if (angle == -90) return {0, -1};
    if (std::fabs(angle) == 180) return {-1, 0};
    const double radians = angle * (std::numbers::pi / 180);
    return {std::cos(radians), std::sin(radians)};
  }
};

/// The rotation in the plane, counter-clockwise seen from the positive end of its tool axis, that takes the point
/// `from` to the point `to`; with both the same, the rotation about that point. The tool axis keeps its positions.
inline Mat4 rotation_in(const PlaneAxes& plane, double degrees, const ig::Vec3& from, const ig::Vec3& to) {
  const Turn turn = Turn::by(degrees);
  const std::size_t u = plane.first, v = plane.second;
  Mat4 m = identity_frame;
  m[4 * u + u] = m[4 * v + v] = turn.cos;
  m[4 * u + v] = turn.sin;
  m[4 * v + u] = -turn.sin;
  const ig::Vec3 turned = mapped(m, from);
  m[12 + u] = to[u] - turned[u];
  m[12 + v] = to[v] - turned[v];
  return m;
}

inline bool is_finite(const Mat4& m) {
  for (const double element : m)
    if (!std::isfinite(element)) return false;
  return true;
}

/// A member of each syntax that asks for the entry or writes it.
class TiltFrame {
 public:
  explicit TiltFrame(ig::Access access) : frame_("TiltTransform", access) {}

  /// Nothing is tilted where nothing was said.
  Mat4 get(const ig::Block& b) const {
    Mat4 m;
    return b.host()->transform(b.raw(), frame_.id(), m.data()) != 0 ? m : identity_frame;
  }
  void set(ig::Block& b, const Mat4& m) const { b.host()->set_transform(b.raw(), frame_.id(), m.data()); }
  bool is_fresh(const ig::Block& b) const { return b.is_fresh(frame_); }

 private:
  ig::Transform frame_;
};

}  // namespace iso
