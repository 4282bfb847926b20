/// A, B and C become machine coordinates. X, Y and Z of the machine stay where they are in a block that names rotary
/// axes only: the axes turn, nothing follows them, unless the frame moves with them (G43.4).
#include "rotary_words.hpp"

namespace iso {
namespace {

struct McAbc {
  static constexpr auto spec = ig::syntax("McAbcSyntax", "A B C become machine coordinates.")
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
  DistanceMode distance_;

  ig::Status build(ig::Block& b) {
    if (b.is_raised(axis_words_void_)) return ig::Status::unchanged;
    const PartialAngles to = take(b);
    if (to.mask == 0) return ig::Status::changed;
    rotary_.set(b, to);
    if (!b.is_fresh(machine_)) {
      const ig::PartialVec3 carried = b.get(machine_);
      if (carried.complete()) b.set(machine_, carried.value);
    }
    for (std::uint32_t step = 0, n = steps_.count(b); step < n; ++step)
      if (steps_.is_move(b, step)) steps_.set(b, step, to);
    b.raise(turns_);
    if (distance_.is_incremental(b)) b.raise(as_increment_);
    return ig::Status::changed;
  }

 private:
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

const ig::Register<McAbc> registered;

}  // namespace
}  // namespace iso
