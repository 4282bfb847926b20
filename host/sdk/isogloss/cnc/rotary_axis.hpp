/// The rotary axes A, B and C: which of them the machine has, where they stand, and where a block sends them. Angles in
/// degrees of the machine; index 0 is A.
#pragma once

#include <cstddef>

#include "isogloss/cnc/program_xyz.hpp"
#include "isogloss/cnc/rotary_angle.hpp"

namespace ig::cnc {

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
