/// The rotary axes A, B and C: which of them the machine has, where they stand, where a block sends them, and which way
/// they turn (Fanuc manual, "Rotary axis roll-over"). Angles in degrees of the machine; index 0 is A.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "isogloss/cnc/program_xyz.hpp"

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
  ig_field named[3];
  ig_value v[3];
  std::uint32_t n = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!to.has(axis)) continue;
    named[n] = fields[axis];
    v[n++].number = to.value[axis];
  }
  b.set_many(named, n, v);
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

/// A member of each syntax that asks where the rotary axes are, or where its block sends them, before McAbcSyntax has
/// run. Declare read | wake to run in blocks that hold A, B or C.
class RotaryAngles {
 public:
  explicit RotaryAngles(Access words = read)
      : words_{word("Parsing.A", words), word("Parsing.B", words), word("Parsing.C", words)} {}

  /// A, B and C of this block, as programmed.
  PartialAngles words(const Block& b) const { return angles_of(b, words_); }

  /// Where the axes are before the words of this block act: the carried angles, or those that an earlier syntax (G53.1)
  /// wrote.
  PartialAngles present(const Block& b) const { return angles_of(b, machine_); }

  /// Where the axes are at the end of the block; under G91 the words are distances from their present angles. The
  /// choice between angles that differ by whole turns is not made here.
  PartialAngles target(const Block& b) const {
    PartialAngles to = present(b);
    const PartialAngles named = words(b);
    if (named.mask == 0) return to;
    const bool is_incremental = distance_.is_incremental(b);
    if (is_incremental && b.find(machine_select_)) return to;  // the control ignores G53, and its words, under G91
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!named.has(axis)) continue;
      to.value[axis] = named.value[axis] + (is_incremental && to.has(axis) ? to.value[axis] : 0);
      to.mask |= 1u << axis;
    }
    return to;
  }

 private:
  using Ids = std::array<ig_field, 3>;
  static ig_field word(const char* path, Access access) {
    return Field<double>(path, access, {Life::standard, "deg", ""}).id();
  }

  Ids words_;
  Ids machine_{In<double>("MachineCoordinate.A").id(), In<double>("MachineCoordinate.B").id(),
               In<double>("MachineCoordinate.C").id()};
  Codes machine_select_{{"G53"}, read};
  DistanceMode distance_;
};

/// Raised for an axis whose word has become a position already although the program gave a distance (IC+300 in
/// Klartext): the axis turns by the whole distance, even when that is more than half a turn.
class RotaryIncrements {
 public:
  explicit RotaryIncrements(Access access)
      : axes_{Signal{"McAbc.~IncrementA", access}, Signal{"McAbc.~IncrementB", access},
              Signal{"McAbc.~IncrementC", access}} {}

  bool has(const Block& b, std::size_t axis) const { return b.is_raised(axes_[axis]); }
  void raise(Block& b, std::size_t axis) const { b.raise(axes_[axis]); }

 private:
  std::array<Signal, 3> axes_;
};

/// The machine's rotary axes, from its services, asked once when the chain is created.
class RotaryAxes {
 public:
  RotaryAxes() {
    for (std::size_t axis = 0; axis < 3; ++axis) ask(axis);
    ask_kinematics();
  }

  bool has(std::size_t axis) const { return (mask_ >> axis & 1u) != 0; }
  bool any() const { return mask_ != 0; }
  Rollover rollover(std::size_t axis) const { return rollover_[axis]; }
  const AngleRange& travel(std::size_t axis) const { return travel_[axis]; }

  /// The angle to which the axis goes from `from` when the position `to` is commanded.
  double approach(std::size_t axis, double from, double to, HalfTurn half = HalfTurn::positive) const {
    switch (rollover_[axis]) {
      case Rollover::shortest: return nearest_turn_inside(from, to, travel_[axis], half);
      case Rollover::signed_direction: return directed_turn(from, to);
      default: return to + 0.0;
    }
  }

 private:
  void ask(std::size_t axis) {
    if (!service_) return;
    const ig_machine_axis_1& machine = *service_.operator->();
    const char name = rotary_names[axis];
    double position = 0;
    bool is_there = machine.home(machine.self, name, &position) != 0 ||
                    machine.reference(machine.self, name, 1, &position) != 0 ||
                    machine.rapid_rate(machine.self, name, &position) != 0;
    AngleRange travel;
    const bool is_limited = machine.travel(machine.self, name, &travel.minimum, &travel.maximum) != 0;
    if (is_limited) travel_[axis] = travel;
    rollover_[axis] = is_limited ? Rollover::counts_on : Rollover::shortest;
    constexpr std::size_t with_rollover = offsetof(ig_machine_axis_1, rollover) + sizeof machine.rollover;
    std::uint32_t mode = 0;
    const bool is_known = machine.struct_size >= with_rollover && machine.rollover != nullptr &&
                          machine.rollover(machine.self, name, &mode) != 0 && mode <= 2;
    if (is_known) rollover_[axis] = static_cast<Rollover>(mode);
    is_there = is_there || is_limited || is_known;
    if (is_there) mask_ |= 1u << axis;
  }
  /// An axis that turns the tool or the workpiece exists, whether or not its limits and its rate are known.
  void ask_kinematics() {
    if (!kinematics_) return;
    char names[2] = {};
    const std::uint32_t n = kinematics_->axes(kinematics_->self, names);
    for (std::uint32_t i = 0; i < n && i < 2; ++i)
      if (const std::size_t axis = rotary_names.find(names[i]); axis < 3) mask_ |= 1u << axis;
  }

  Service<ig_machine_axis_1> service_{"isogloss.machine-axis/1", Need::optional,
                                      "Which rotary axes there are, and how they turn."};
  Service<ig_machine_kinematics_1> kinematics_{"isogloss.machine-kinematics/1", Need::optional,
                                               "Which rotary axes turn the tool or the workpiece."};
  std::uint32_t mask_ = 0;
  std::array<Rollover, 3> rollover_{Rollover::shortest, Rollover::shortest, Rollover::shortest};
  std::array<AngleRange, 3> travel_;
};

}  // namespace ig::cnc
