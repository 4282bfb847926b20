/// Reference positions of the machine's axes, and what G27 to G30 do with the rotary axes.
#pragma once

#include <isogloss/cnc/rotary_turns.hpp>
#include <isogloss/cnc/rotary_words.hpp>

#include "motion/further_axis_order.hpp"

namespace iso {

using namespace ig::cnc;

/// A member of each syntax that goes to a reference position. X Y Z A B C are axes 0 to 5.
class ReferencePositions {
 public:
  /// Reference position 1 to 4 of an axis, in mm or degrees of the machine. Machine zero, reported at `code`, where the
  /// machine does not know it.
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

/// A member of each syntax that sends rotary axes through an intermediate point to a reference position.
class RotaryReturn {
 public:
  /// The axis words of a call for rotary axes that the machine has; the other ones are reported.
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
  /// The present angles of all rotary axes of the machine.
  PartialAngles all(const ig::Block& b) const {
    PartialAngles all{0, present(b)};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (words_.axes().has(axis)) all.mask |= 1u << axis;
    return all;
  }
  /// False, with a diagnostic, where the axis cannot go to the angle.
  bool accept(ig::Block& b, std::size_t axis, double angle) const { return words_.accept(b, axis, angle, IG_NO_FIELD); }
  Angles present(const ig::Block& b) const { return before_.get(b).or_else({}); }

  /// The angles to which the axes go for the words of the block: positions, or distances under G91.
  PartialAngles approach(const ig::Block& b, const PartialAngles& to) const {
    PartialAngles out = to;
    const Angles from = present(b);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (to.has(axis) && !distance_.is_incremental(b)) out.value[axis] = approach(axis, from[axis], to.value[axis]);
    return out;
  }
  double approach(std::size_t axis, double from, double to) const { return words_.axes().approach(axis, from, to); }
  /// The angle for a machine position approached from `from`; the sign of the position is not a direction.
  double to_machine(std::size_t axis, double from, double position) const {
    return words_.axes().rollover(axis) == Rollover::counts_on ? position : nearest_turn(from, position);
  }

  /// Adds these angles to the step that was appended last.
  void step(ig::Block& b, const PartialAngles& to) const { steps_.set_last(b, to); }
  /// The angles at the end of the block.
  void end(ig::Block& b, const PartialAngles& to) const { position_.set(b, to); }

 private:
  RotaryWords words_;
  RotaryPosition position_{ig::read | ig::write};
  RotaryPosition before_{ig::previous};
  RotarySteps steps_;
  DistanceMode distance_;
};

/// The axes that a call names: X Y Z, and those of A B C that the machine has. Positions in mm and degrees.
struct NamedAxes {
  ig::PartialVec3 linear;
  PartialAngles rotary;
};

/// A member of G27 to G30: reads the axes of the call, and moves all of them together by rapid.
class ReferenceMove {
 public:
  static bool names_axes(const ig::Words& words) { return (words.mask & 63u) != 0; }  // X Y Z A B C, its first words

  /// Reports (ISO-0340) a call without axes. Nothing where it names none that the machine has.
  std::optional<NamedAxes> named(ig::Block& b, const ig::Words& words, const ig::Call& call) const {
    const NamedAxes axes{axis_words(words), rotary.named(b, words, call)};
    if (!names_axes(words) && !names_further(b))
      b.report(ig::diag("ISO-0340"), ig::Where::word(call.code(0)), b.text(words.code));
    return axes.linear.mask == 0 && axes.rotary.mask == 0 ? std::nullopt : std::optional(axes);
  }

  void begin(ig::Block& b, ig::Symbol code) const { motion_.begin(b, code); }
  /// By rapid to a point of the program, which is `machine` in machine coordinates, and to the angles of the machine.
  void pass(ig::Block& b, const ig::Vec3& point, const ig::Vec3& at_machine, const PartialAngles& angles) const {
    motion_.rapid_to(b, point, at_machine);
    rotary.step(b, angles);
  }
  /// The same, and the block ends there.
  void arrive(ig::Block& b, const ig::Vec3& point, const ig::Vec3& at_machine, const PartialAngles& angles) const {
    pass(b, point, at_machine, angles);
    b.set(program, point);
    b.set(machine, at_machine);
    rotary.end(b, angles);
  }

  ig::Xyz program{"ProgramXyz", ig::write};
  ig::Xyz machine{"MachineCoordinate", ig::write};
  RotaryReturn rotary;
  NamesFurtherAxes names_further;

 private:
  ig::CompoundMotion motion_;
};

/// A frame that depends on the rotary axes (a tilted plane after G53.1, tool centre point control). A member of each
/// syntax that turns them to positions of the machine.
class TurnedFrame {
 public:
  /// The frame for the new angles.
  void turn(ig::Block& b, const PartialAngles& to) const {
    const PartialAngles before = pivot_.get(b);
    if (before.mask == 0 || to.mask == 0 || !kinematics_) return;
    const Angles angles = to.or_else(before.value);
    const auto pivot = kinematics_.pivot(angles);
    if (!pivot || !is_finite(*pivot)) return;
    const double length = b.get_or(offset_, 0.0);
    if (const auto tool = kinematics_.tool_axis(angles); tool && length != 0) b.set_translation(frame_, length * *tool);
    b.set_transform(turned_, *pivot);
    pivot_.set(b, kinematics_, angles);
  }

 private:
  ig::Field<double> offset_{"ToolHeightCompensation.Offset_mm", ig::read};
  ig::Transform frame_{"ToolHeightCompensation", ig::read | ig::write};
  ig::Transform turned_{"PivotTransform", ig::read | ig::write};
  PivotState pivot_{ig::read | ig::write};
  ToolKinematics kinematics_;
};

inline ig::Status not_invertible(ig::Block& b) {
  b.report(ig::diag("ISO-0332"), ig::Where::block());
  return ig::Status::changed;
}

}  // namespace iso
