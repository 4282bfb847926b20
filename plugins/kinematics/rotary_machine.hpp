/// The geometry of one or two rotary axes on tables and heads. Inside: column vectors, mm and radians; in the public
/// functions degrees of the machine.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>

#include <isogloss/cnc/units.hpp>
#include <numbers>

namespace kinematics {

using namespace ig::cnc;

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;
using Angles = std::array<double, 3>;  ///< of A, B and C

/// Cosine and sine of an angle in degrees, exact at multiples of 90.
struct Turn {
  double cos = 1, sin = 0;

  static Turn by(double degrees) {
    // remainder() is slow; the difference is exact as well while the quarters are few.
    const double angle = std::fabs(degrees) < 1e9 ? degrees : std::remainder(degrees, 360.0);
    const long quarter = std::lrint(angle / 90);
    const double radians = (angle - 90 * static_cast<double>(quarter)) * radians_per_degree;
    const double c = std::cos(radians), s = std::sin(radians);
    switch (quarter & 3) {
      case 0: return {c, s};
      case 1: return {-s, c};
      case 2: return {-c, -s};
      default: return {s, -c};
    }
  }
};

/// The angle in degrees, in (-180, 180].
inline double to_degrees(double radians) {
  const double degrees = radians * degrees_per_radian;
  return degrees <= -180 ? degrees + 360 : degrees;
}
inline double within_half_turn(double degrees) {
  const double angle = std::remainder(degrees, 360.0);
  return angle <= -180 ? 180 : angle;
}

enum class Place : std::uint8_t { table, head };

/// A positive angle turns the tool right-handed about the direction, relative to the workpiece.
struct RotaryAxis {
  std::size_t letter = 0;  ///< of A, B, C
  Place place = Place::table;
  Vector direction = Vector::UnitZ();  ///< unit vector
  Vector point = Vector::Zero();       ///< a point on the axis; for a head, from the gauge point
  double sign = 1;
  double zero = 0;  ///< deg, the displayed angle at which the axis is geometrically at zero

  double geometric(double angle) const { return sign * (angle - zero); }
  double shown(double radians) const { return within_half_turn(zero + sign * to_degrees(radians)); }
};

struct Solution {
  Angles angles{};
  std::uint32_t free = 0;  ///< a bit for each of A, B, C
};

struct Pose {
  Matrix rotation;     ///< with the translation: from workpiece to machine
  Vector translation;  ///< mm
  Vector tool_axis;    ///< from the tip to the holder, a unit vector in coordinates of the workpiece
};

/// A vector rotated about a unit vector (Rodrigues' formula).
inline Vector turned(const Vector& v, const Vector& about, const Turn& by) {
  return by.cos * v + (1 - by.cos) * about.dot(v) * about + by.sin * about.cross(v);
}

class RotaryMachine {
 public:
  /// Adds an axis, at most two, the one nearer the machine's base first. Two axes with parallel directions are not
  /// allowed.
  void add(const RotaryAxis& axis) { axes_[count_++] = axis; }
  std::size_t count() const { return count_; }
  const RotaryAxis& axis(std::size_t i) const { return axes_[i]; }

  /// Computes what does not depend on the angles; call it after the last add().
  void prepare();

  /// What the axes do to the workpiece and the tool at these angles. Kept until other angles are asked for, because a
  /// block asks for the place of the workpiece and for the tool axis one after the other.
  const Pose& pose(const Angles& angles) const {
    bool is_kept = has_pose_;
    for (std::size_t i = 0; i < count_; ++i) is_kept = is_kept && angles[axes_[i].letter] == last_[i].angle;
    if (!is_kept) set_pose(angles);
    return pose_;
  }

  /// The velocity of the machine's X Y Z while the tip at `tip` moves at `tip_speed` and the axes turn at `turning`, in
  /// deg/s. It is the derivative of pivot(tip + length tool_axis), in the same order of steps.
  Vector axis_speeds(const Angles& angles, const Angles& turning, const Vector& tip, double length,
                     const Vector& tip_speed) const;

  /// The angles that turn the tool to `direction`, a unit vector: 0, 1 or 2 solutions.
  std::uint32_t solve(const Vector& direction, const Angles& present, std::array<Solution, 2>& out) const;

 private:
  std::uint32_t solve_two(const Vector& direction, std::array<Solution, 2>& out) const;
  /// One axis alone, or with an inner axis along the tool, which does not tilt it.
  std::uint32_t solve_one(const Vector& direction, Solution& out) const;
  double inner_angle(const Vector& v) const { return std::atan2(side_.dot(v), lever_.dot(v)); }
  void set(std::size_t i, double radians, Solution& out) const {
    out.angles[axes_[i].letter] = axes_[i].shown(radians);
  }
  void keep(std::size_t i, Solution& out) const { out.free |= 1u << axes_[i].letter; }

  struct Moving {
    Vector at, speed;
  };
  /// The speed of the tool relative to the workpiece, in rad/s.
  double speed_of(std::size_t i, const Angles& turning) const {
    return axes_[i].sign * turning[axes_[i].letter] * radians_per_degree;
  }
  Moving carried(const Moving& v, std::size_t i, const Angles& angles, const Angles& turning) const {
    return carried(v, axes_[i].direction, turn_of(i, angles), speed_of(i, turning));
  }
  Moving carried_back(const Moving& v, std::size_t i, const Angles& angles, const Angles& turning) const {
    const Turn& turn = turn_of(i, angles);
    return carried(v, axes_[i].direction, {turn.cos, -turn.sin}, -speed_of(i, turning));
  }
  static Moving carried(const Moving& v, const Vector& about, const Turn& by, double speed) {
    const Vector at = turned(v.at, about, by);
    return {at, turned(v.speed, about, by) + speed * about.cross(at)};
  }

  void set_pose(const Angles& angles) const;

  /// Kept for each axis, because many blocks turn only one of the two.
  const Turn& turn_of(std::size_t i, const Angles& angles) const {
    Last& last = last_[i];
    const double angle = angles[axes_[i].letter];
    if (angle != last.angle) {
      last = {angle, Turn::by(axes_[i].geometric(angle))};
      has_pose_ = false;
    }
    return last.turn;
  }

  struct Last {
    double angle = std::nan("");
    Turn turn{};
  };

  std::array<RotaryAxis, 2> axes_;
  std::size_t count_ = 0;
  std::size_t outer_ = 0, inner_ = 0;  // in the order from the workpiece to the tool
  Vector tool_ = Vector::UnitZ();
  double height_ = 0, cos_between_ = 0, sin_between_ = 0;
  Vector lever_ = Vector::Zero(), side_ = Vector::Zero();  // of the tool about the inner axis
  Vector u_ = Vector::Zero(), w_ = Vector::Zero();
  mutable std::array<Last, 2> last_;
  mutable Pose pose_;  // for the angles of last_
  mutable bool has_pose_ = false;
};

}  // namespace kinematics
