/// A, B and C become machine coordinates. In a block that names only rotary axes, the machine's X, Y and Z do not move,
/// unless the frame moves with the rotary axes (G43.4).
#include <isogloss/cnc/rotary_words.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct McAbc {
  static constexpr auto spec = ig::syntax("McAbcSyntax", "Turns A B C into machine coordinates.")
                                   .after("DecimalPointSyntax", "CannedCycleResolveSyntax", "DrillingCycleSyntax",
                                          "IncrementalResolveSyntax", "MachineCoordSelectSyntax", "McXyzSyntax")
                                   .before("McAbcCyclicPathSyntax", "CircularMotionSyntax", "LinearMotionSyntax");

  std::array<ig::Word, 3> words_{ig::Word{"Parsing.A"}, ig::Word{"Parsing.B"}, ig::Word{"Parsing.C"}};
  ig::Xyz machine_{"MachineCoordinate", ig::read | ig::write};
  RotaryPosition rotary_{ig::read | ig::write};
  RotarySteps steps_;
  RotaryWords machine_axes_;
  ig::Signal axis_words_void_{"MachineCoordSelect.~AxisWordsVoid", ig::read};
  ig::Signal turns_{"McAbc.~Turns", ig::write};
  ig::Signal as_increment_{"McAbc.~AsIncrement", ig::write};
  ig::In<std::int64_t> repeats_{"CannedCycle.Repeats"};
  std::array<ig::In<double>, 3> turn_{ig::In<double>{"CannedCycle.Increment.A"},
                                      ig::In<double>{"CannedCycle.Increment.B"},
                                      ig::In<double>{"CannedCycle.Increment.C"}};
  DistanceMode distance_;

  ig::Status build(ig::Block& b) {
    if (b.is_raised(axis_words_void_)) return ig::Status::unchanged;
    PartialAngles to = take(b);
    if (to.mask == 0) return ig::Status::changed;
    if (!b.is_fresh(machine_)) {
      const ig::PartialVec3 carried = b.get(machine_);
      if (carried.complete()) b.set(machine_, carried.value);
    }
    turn_steps(b, to);
    rotary_.set(b, to);
    b.raise(turns_);
    if (distance_.is_incremental(b)) b.raise(as_increment_);
    return ig::Status::changed;
  }

 private:
  /// All holes of a repeat have the same number of steps, and the first step of each is the positioning. `to` becomes
  /// the angles at the end.
  void turn_steps(ig::Block& b, PartialAngles& to) const {
    const std::uint32_t steps = steps_.count(b);
    if (steps == 0) return;
    const auto holes = static_cast<std::uint32_t>(b.get_or(repeats_, std::int64_t{1}));
    const std::uint32_t of_hole = std::max(1u, steps / std::max(1u, holes));
    for (std::uint32_t step = 0; step < steps; ++step) {
      if (step != 0 && step % of_hole == 0 && step / of_hole < holes) turn_on(b, to);
      if (steps_.is_move(b, step)) steps_.set(b, step, to);
    }
  }
  void turn_on(const ig::Block& b, PartialAngles& to) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (to.has(axis)) to.value[axis] += b.get_or(turn_[axis], 0.0);
  }

  PartialAngles take(ig::Block& b) const {
    PartialAngles to;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto word = b.take(words_[axis]);
      if (!word || !machine_axes_.accept(b, axis, *word, words_[axis].id())) continue;
      to.mask |= 1u << axis;
      to.value[axis] = *word;
    }
    return to;
  }
};

const ig::Register<McAbc> mc_abc_syntax;

}  // namespace
}  // namespace iso
