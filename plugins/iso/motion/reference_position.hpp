/// Reference positions of the machine's axes, and what G27 to G30 do with the rotary ones.
#pragma once

#include <isogloss/cnc/rotary_words.hpp>

namespace iso {

using namespace ig::cnc;

/// A member of each syntax that goes to a reference position. X Y Z A B C are axes 0 to 5.
class ReferencePositions {
 public:
  /// mm and degrees in machine coordinates, of position 1 to 4; machine zero, said at `code`, where the machine does
  /// not know it.
  double operator()(ig::Block& b, std::size_t axis, std::uint32_t which, ig_field code) const {
    const char name = "XYZABC"[axis];
    double position = 0;
    if (axes_ && axes_->reference(axes_->self, name, which, &position) != 0) return position;
    b.report(ig::diag("ISO-0341"), ig::Where::word(code), double(which), std::string_view(&name, 1));
    return 0;
  }

 private:
  ig::Service<ig_machine_axis_1> axes_{"isogloss.machine-axis/1", ig::Need::optional, "Reference positions."};
};

/// The axis words of a call, as a point of which some axes have a value.
inline ig::PartialVec3 axis_words(const ig::Words& words) {
  ig::PartialVec3 named;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const auto word = words["XYZ"[axis]]) {
      named.mask |= 1u << axis;
      named.value[axis] = *word;
    }
  return named;
}

/// A member of each syntax that sends rotary axes over a point to a reference position.
class RotaryReturn {
 public:
  /// The axis words of a call that name rotary axes of the machine; others are said.
  PartialAngles named(ig::Block& b, const ig::Words& words, const ig::Call& call) const {
    PartialAngles named;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto word = words[rotary_names[axis]];
      if (!word || !words_.accept(b, axis, *word, call.word(words.row, rotary_names[axis]))) continue;
      named.mask |= 1u << axis;
      named.value[axis] = *word;
    }
    return named;
  }
  /// All of the machine, where they stand.
  PartialAngles all(const ig::Block& b) const {
    PartialAngles all{0, present(b)};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (words_.axes().has(axis)) all.mask |= 1u << axis;
    return all;
  }
  Angles present(const ig::Block& b) const { return before_.get(b).or_else({}); }

  /// To the positions that the block names; under G91 they are as far away as it says.
  PartialAngles approach(const ig::Block& b, const PartialAngles& to) const {
    PartialAngles out = to;
    const Angles from = present(b);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (to.has(axis) && !distance_.is_incremental(b)) out.value[axis] = approach(axis, from[axis], to.value[axis]);
    return out;
  }
  double approach(std::size_t axis, double from, double to) const { return words_.axes().approach(axis, from, to); }
  /// On from there to a position of the machine, whose sign is no direction.
  double to_machine(std::size_t axis, double from, double position) const {
    return words_.axes().rollover(axis) == Rollover::counts_on ? position : nearest_turn(from, position);
  }

  /// The step that was appended last moves to these angles.
  void step(ig::Block& b, const PartialAngles& to) const { steps_.set_last(b, to); }
  /// The block ends at these angles.
  void end(ig::Block& b, const PartialAngles& to) const { position_.set(b, to); }

 private:
  RotaryWords words_;
  RotaryPosition position_{ig::read | ig::write};
  RotaryPosition before_{ig::previous};
  RotarySteps steps_;
  DistanceMode distance_;
};

inline ig::Status not_invertible(ig::Block& b) {
  b.report(ig::diag("ISO-0332"), ig::Where::block());
  return ig::Status::changed;
}

}  // namespace iso
