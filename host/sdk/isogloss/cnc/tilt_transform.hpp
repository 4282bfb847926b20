/// Rotations of the programmed coordinates: the entry TiltTransform of the frame. Matrices have the form that the block
/// document uses: row vectors, translation in elements 12 to 14. Lengths in mm, angles in degrees.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "isogloss/cnc/plane.hpp"
#include "isogloss/cnc/units.hpp"

namespace ig::cnc {

using Mat4 = std::array<double, 16>;

inline constexpr Mat4 identity_frame{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

inline Vec3 mapped(const Mat4& m, const Vec3& p) {
  return {p.x * m[0] + p.y * m[4] + p.z * m[8] + m[12], p.x * m[1] + p.y * m[5] + p.z * m[9] + m[13],
          p.x * m[2] + p.y * m[6] + p.z * m[10] + m[14]};
}

/// Cosine and sine of an angle in degrees, exact at multiples of 90.
struct Turn {
  double cos = 1, sin = 0;

  static Turn by(double degrees) {
    const double angle = std::remainder(degrees, 360.0);
    if (angle == 0) return {1, 0};
    if (angle == 90) return {0, 1};
    if (angle == -90) return {0, -1};
    if (std::fabs(angle) == 180) return {-1, 0};
    const double radians = angle * radians_per_degree;
    return {std::cos(radians), std::sin(radians)};
  }
};

/// The rotation in the plane that takes the point `from` to the point `to`, counter-clockwise seen from the positive
/// end of the tool axis; where both are the same point, the rotation is about it. Coordinates along the tool axis do
/// not change.
inline Mat4 rotation_in(const PlaneAxes& plane, double degrees, const Vec3& from, const Vec3& to) {
  const Turn turn = Turn::by(degrees);
  const std::size_t u = plane.first, v = plane.second;
  Mat4 m = identity_frame;
  m[4 * u + u] = m[4 * v + v] = turn.cos;
  m[4 * u + v] = turn.sin;
  m[4 * v + u] = -turn.sin;
  const Vec3 turned = mapped(m, from);
  m[12 + u] = to[u] - turned[u];
  m[12 + v] = to[v] - turned[v];
  return m;
}

/// The map that applies `a` first, then `b`.
inline Mat4 product(const Mat4& a, const Mat4& b) {
  Mat4 m = identity_frame;
  for (std::size_t row = 0; row < 16; row += 4)
    for (std::size_t column = 0; column < 3; ++column)
      m[row + column] = a[row] * b[column] + a[row + 1] * b[4 + column] + a[row + 2] * b[8 + column] +
                        (row == 12 ? b[12 + column] : 0.0);
  return m;
}

/// The inverse of a rotation with a translation; other matrices have no inverse here.
inline Mat4 inverse(const Mat4& m) {
  Mat4 out = identity_frame;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) out[4 * row + column] = m[4 * column + row];
  for (std::size_t column = 0; column < 3; ++column)
    out[12 + column] = -(m[12] * out[column] + m[13] * out[4 + column] + m[14] * out[8 + column]);
  return out;
}

inline Vec3 origin(const Mat4& m) { return {m[12], m[13], m[14]}; }
inline Mat4 at_origin(Mat4 m, const Vec3& origin) {
  for (std::size_t axis = 0; axis < 3; ++axis) m[12 + axis] = origin[axis];
  return m;
}

inline double scalar_product(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 vector_product(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The vector with length 1; nothing for a vector of length 0 or one that is not finite. The vector is scaled first,
/// because the squares of large components overflow.
inline std::optional<Vec3> unit(Vec3 v) {
  const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
  v = {v.x / largest, v.y / largest, v.z / largest};
  const double length = std::sqrt(scalar_product(v, v));
  return Vec3{v.x / length, v.y / length, v.z / length};
}

/// The right-handed rotation about an axis (0 X, 1 Y, 2 Z): a point moves from the first of the two other axes towards
/// the second.
inline Mat4 turn_about(std::size_t axis, double degrees) {
  return rotation_in(axis == 0 ? yz_plane : axis == 1 ? zx_plane : xy_plane, degrees, {}, {});
}

/// How a tilted plane lies in the workpiece (Fanuc 30i manual, "Tilted working plane"). The rows of such a matrix are
/// the plane's own axes in coordinates of the workpiece: the programmed point x y z lies at x times the first row plus
/// y times the second plus z times the third.
///
/// Euler angles about Z, X', Z'': each about the axes as turned so far, which is the reverse order about fixed axes.
inline Mat4 euler_zxz(const Vec3& angles) {
  return product(product(turn_about(2, angles.z), turn_about(0, angles.y)), turn_about(2, angles.x));
}

enum class TurnedAxes { fixed, turned };

/// Rotations by angles.x about X, angles.y about Y and angles.z about Z, in the given order of axes: about the axes of
/// the workpiece (fixed), or about the axes that the rotations before have turned (turned).
inline Mat4 roll_pitch_yaw(const Vec3& angles, const std::array<std::size_t, 3>& order, TurnedAxes axes) {
  Mat4 m = identity_frame;
  for (const std::size_t axis : order) {
    const Mat4 turn = turn_about(axis, angles[axis]);
    m = axes == TurnedAxes::fixed ? product(m, turn) : product(turn, m);
  }
  return m;
}

/// The plane with X' along x and Y' on the side to which `side` points; nothing where the two span no plane.
inline std::optional<Mat4> from_x_and_side(const Vec3& x, const Vec3& side) {
  constexpr double least_sine = 1e-9;
  const auto along = unit(x), to_side = unit(side);
  if (!along || !to_side) return std::nullopt;
  const Vec3 normal = vector_product(*along, *to_side);
  if (std::sqrt(scalar_product(normal, normal)) < least_sine) return std::nullopt;
  const Vec3 z = *unit(normal), y = vector_product(z, *along);
  return Mat4{along->x, along->y, along->z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, 0, 0, 0, 1};
}

/// The plane with Z' along z and X' as near to x as possible; nothing where the two span no plane.
inline std::optional<Mat4> from_z_and_x(const Vec3& z, const Vec3& x) {
  const auto turned = from_x_and_side(z, x);  // its first row is Z', its second X'
  if (!turned) return std::nullopt;
  const Mat4& t = *turned;
  return Mat4{t[4], t[5], t[6], 0, t[8], t[9], t[10], 0, t[0], t[1], t[2], 0, 0, 0, 0, 1};
}

/// Projection angles: X turned about Y by the first angle is X'; Y turned about X by the second lies in the plane; the
/// third turns both about Z'. Nothing where the first two directions coincide.
inline std::optional<Mat4> from_projections(const Vec3& angles) {
  const Turn about_y = Turn::by(angles.x), about_x = Turn::by(angles.y);
  const auto untwisted = from_x_and_side({about_y.cos, 0, -about_y.sin}, {0, about_x.cos, about_x.sin});
  if (!untwisted) return std::nullopt;
  return product(turn_about(2, angles.z), *untwisted);
}

inline bool is_finite(const Mat4& m) {
  // An infinity or a NaN makes its sum NaN. Two sums, since one would wait for each of its additions.
  double even = 0, odd = 0;
  for (std::size_t i = 0; i < m.size(); i += 2) {
    even += 0 * m[i];
    odd += 0 * m[i + 1];
  }
  return even + odd == 0;
}

/// A member of each syntax that reads or writes the entry.
class TiltFrame {
 public:
  explicit TiltFrame(Access access) : frame_("TiltTransform", access) {}

  /// The entry's matrix; the identity where it is not set.
  Mat4 get(const Block& b) const {
    Mat4 m;
    return b.get(frame_, m) ? m : identity_frame;
  }
  void set(Block& b, const Mat4& m) const { b.set_transform(frame_, m); }
  bool is_fresh(const Block& b) const { return b.is_fresh(frame_); }

 private:
  Transform frame_;
};

}  // namespace ig::cnc
