/// Angles of the rotary axes A, B and C, and the turns from one to another (Fanuc manual, "Rotary axis roll-over").
/// Degrees; index 0 is A.
#pragma once

#include <cmath>
#include <limits>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

using Angles = std::array<double, 3>;
inline constexpr std::string_view rotary_names = "ABC";

/// Angles of some of the axes: bit 0 of the mask is A.
struct PartialAngles {
  std::uint32_t mask = 0;
  Angles value{};
  constexpr bool has(std::size_t axis) const { return (mask >> axis & 1u) != 0; }
  constexpr Angles or_else(const Angles& other) const {
    return {has(0) ? value[0] : other[0], has(1) ? value[1] : other[1], has(2) ? value[2] : other[2]};
  }
};

/// The values of three fields, those of A, B and C, as far as they are present.
inline PartialAngles angles_of(const Block& b, const std::array<ig_field, 3>& fields) {
  PartialAngles out;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ig_value v;
    if (!b.get(fields[axis], v)) continue;
    out.mask |= 1u << axis;
    out.value[axis] = v.number;
  }
  return out;
}

/// Writes the angles that are present.
inline void set_angles(Block& b, const std::array<ig_field, 3>& fields, const PartialAngles& to) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (to.has(axis)) b.set(fields[axis], to.value[axis]);
}

/// Angles that differ by at most this many degrees are the same position; limits of travel are inclusive by as much.
inline constexpr double same_angle_deg = 1e-6;

/// How an axis goes to a programmed position; the numbers are those of ig_machine_axis_1::rollover. counts_on: to the
/// angle itself, beyond 360 too; shortest: the shortest way; signed_direction: in the direction of the sign.
enum class Rollover : std::uint32_t { counts_on, shortest, signed_direction };
/// The direction of a turn of exactly 180 degrees, where both ways are equally short.
enum class HalfTurn { positive, negative };

/// The travel of an axis in degrees, limits inclusive; without limits by default.
struct AngleRange {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  constexpr bool holds(double angle) const {
    return angle >= minimum - same_angle_deg && angle <= maximum + same_angle_deg;
  }
};

namespace detail {

/// An angle of this size or more says nothing about a position on the circle: a double has too few digits.
inline constexpr double countable_deg = 1e9;
inline double countable(double angle) { return std::fabs(angle) < countable_deg ? angle : std::fmod(angle, 360); }

}  // namespace detail

/// The angle that names the position `to` on the circle and is nearest to `from`: 370 for 10 after 350, -90 for 270
/// after 0. Whole turns are added to `to`, so that 0.3 stays 0.3.
inline double nearest_turn(double from, double to, HalfTurn half = HalfTurn::positive) {
  constexpr double noise = 1e-9;
  if (std::fabs(to - from) < 179 && std::fabs(from) < detail::countable_deg) return to + 0.0;  // + 0.0: no -0
  to = detail::countable(to);
  if (!(std::fabs(from) < detail::countable_deg)) return to;
  double turns = std::round((from - to) / 360);
  const double way = to + 360 * turns - from;
  if (half == HalfTurn::positive && way < -180 + noise) ++turns;
  if (half == HalfTurn::negative && way > 180 - noise) --turns;
  return to + 360 * turns + 0.0;
}

/// The angle at which the axis stands after turning from `from`, in the direction of the sign of `to`, to the position
/// that `to` names without its sign. Where the axis already is at the position, it does not turn.
inline double directed_turn(double from, double to) {
  const bool backwards = to < 0;
  to = std::fmod(std::fabs(to), 360);
  if (!(std::fabs(from) < detail::countable_deg)) return to;
  const double nearest = nearest_turn(from, to);
  const double way = nearest - from;
  if (std::fabs(way) < same_angle_deg) return nearest;
  if (backwards) return way > 0 ? nearest - 360 : nearest;
  return way < 0 ? nearest + 360 : nearest;
}

/// The nearest turn; where that is outside the travel, the next turn towards the travel if it lies inside, else the
/// nearest one.
inline double nearest_turn_inside(double from, double to, const AngleRange& travel, HalfTurn half) {
  const double nearest = nearest_turn(from, to, half);
  if (travel.holds(nearest)) return nearest;
  const double other = nearest > travel.maximum ? nearest - 360 : nearest + 360;
  return travel.holds(other) ? other : nearest;
}

}  // namespace ig::cnc
