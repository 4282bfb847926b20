/// The frame's last entry, PivotTransform: the workpiece turns with its table, the gauge point with the head. The entry
/// is in the frame while the program describes the workpiece wherever the axes have turned it: under tool centre point
/// control, where the entry and the tool length move with the axes and take the tip along, and after G53.1, where the
/// entry is at rest with them. Otherwise rotary words only turn their axes, and X Y Z are machine directions.
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/rotary_turns.hpp>

#include "five_axis/work_offset_frame.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct PivotTransformation {
  static constexpr auto spec =
      ig::syntax("PivotTransformationSyntax", "Turns the frame with the rotary axes: tool centre point control, G53.1.")
          .after("IsoG68p2TiltSyntax", "G53p1RotaryPositionSyntax", "ToolCenterPointSyntax", "ToolHeightOffsetSyntax",
                 "IsoLocalCoordinateOffsetSyntax", "IsoCoordinateOffsetSyntax", "WorkCoordinateShiftSyntax",
                 "RotaryOffsetSyntax")
          .before("CannedCycleResolveSyntax", "IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");

  ig::InWhile<ig::Symbol> by_angles_{"ToolHeightCompensation.Term", "G43.4", ig::wake};
  ig::InWhile<ig::Symbol> by_direction_{"ToolHeightCompensation.Term", "G43.5"};
  ig::Field<bool> aligned_{"TiltTransform.IsAligned",
                           ig::read | ig::wake | ig::wake_while,
                           {ig::Life::modal, "", "G53.1 or G53.6 has put the tool upright on the plane."}};
  ig::Signal tip_stays_{"PivotTransform.~TipStays", ig::read | ig::wake};
  ig::Field<double> lever_{"PivotTransform.Lever_mm",
                           ig::read,
                           {ig::Life::block, "mm", "How far beyond the tip the point lies that rests under G53.6."}};
  ig::In<double> length_{"ToolHeightCompensation.Offset_mm"};

  PlaneInMachine tilt_;
  ig::Transform tool_{"ToolHeightCompensation", ig::read | ig::write};
  ig::Xyz orientation_{"ToolOrientation", ig::read | ig::write};
  ig::Transform frame_{"PivotTransform", ig::read | ig::write};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Xyz start_{"PivotTransform.Start",
                 ig::write,
                 {ig::Life::block, "mm", "Where the block begins, in its own frame, rotary axes at the start."}};
  ig::Signal turns_{"PivotTransform.~Turns", ig::write};
  ig::Codes machine_select_{{"G53"}, ig::read};
  ToolCenterMode mode_;
  RotaryTurns turn_{ig::read | ig::write, RotaryWordsAre::of_machine};
  LastProgramXyz last_;
  ToolKinematics machine_;

  ig::Status build(ig::Block& b) {
    const bool follows_tip = mode_.is_on(b), is_aligned = b.has(aligned_);
    if (!machine_ || (!follows_tip && !is_aligned)) return leave(b);
    const RotaryTurn turn = turn_.read(b, machine_);
    const bool leads = b.is_raised(tip_stays_) || (follows_tip && !b.find(machine_select_));
    const bool is_tool_anew = follows_tip && (turn.was_moved || !b.get(orientation_).complete());
    if (is_tool_anew) rest_tool(b, turn.from);
    if (!leads) {
      if (follows_tip && turn.moves) turn_tool(b, turn.to);
      const ig::Status frame = rest(b, turn);
      return is_tool_anew ? ig::Status::changed : frame;
    }
    if (!turn.is_followed || turn.was_moved || turn_.state().is_fresh(b)) set(b, turn.from);
    if (!turn.moves) return ig::Status::changed;
    if (!lead(b, turn)) return is_tool_anew ? ig::Status::changed : ig::Status::unchanged;
    if (follows_tip) turn_tool(b, turn.to);
    return ig::Status::changed;
  }

 private:
  ig::Status leave(ig::Block& b) const {
    if (turn_.state().get(b).mask == 0) return ig::Status::unchanged;
    b.set_transform(frame_, identity_frame);
    turn_.state().erase(b);
    return ig::Status::changed;
  }

  bool set(ig::Block& b, const Angles& angles) const {
    const auto pivot = machine_.pivot(angles);
    if (!pivot || !is_finite(*pivot)) return false;
    b.set_transform(frame_, *pivot);
    turn_.state().set(b, machine_, angles);
    return true;
  }

  /// The length lies along the tool axis, with the axes at rest.
  void rest_tool(ig::Block& b, const Angles& angles) const {
    const auto axis = machine_.tool_axis(angles);
    if (!axis) return;
    b.set(orientation_, *axis);
    b.set_translation(tool_, b.get_or(length_, 0.0) * *axis);
  }
  /// The length moves with the tool axis.
  void turn_tool(ig::Block& b, const Angles& to) const {
    const auto axis = machine_.tool_axis(to);
    if (!axis) return;
    b.amend(orientation_, *axis);  // amended, so that no syntax wakes: the length lies along it already
    put_tool(b, b.get_or(length_, 0.0) * *axis);
  }

  /// On a tilted plane without tool centre point control: the axes turn the programmed coordinates, and the machine's X
  /// Y Z do not move.
  ig::Status rest(ig::Block& b, const RotaryTurn& turn) const {
    if (turn.is_followed && !turn.moves && !turn.was_moved) return ig::Status::unchanged;
    return set(b, turn.to) ? ig::Status::changed : ig::Status::unchanged;
  }

  /// The axes turn while the tip goes along its path, to X Y Z of the block; without such words the tip rests.
  bool lead(ig::Block& b, const RotaryTurn& turn) const {
    const auto end = machine_.pivot(turn.to);
    if (!end || !is_finite(*end)) return false;
    if ((b.frame_changed() || b.is_raised(tip_stays_)) && !begin_anew(b, turn)) return false;
    ig::Vec3 tip = last_(b);
    if (const auto lever = b.get(lever_)) {
      const auto before = machine_.tool_axis(turn.from), after = machine_.tool_axis(turn.to);
      if (before && after) tip = tip + unturned(b, *lever * (*after - *before));
    }
    b.set_moving_transform(frame_, *end);
    turn_.state().set(b, machine_, turn.to);
    b.raise(turns_);
    b.set(program_, tip);
    return true;
  }

  /// The frame has changed as well: the block begins where the new frame puts the tip, with the axes at their start.
  bool begin_anew(ig::Block& b, const RotaryTurn& turn) const {
    const auto before = machine_.tool_axis(turn.from), after = machine_.tool_axis(turn.to);
    if (!before || !after) return false;
    const double length = b.get_or(length_, 0.0);
    b.set_translation(tool_, length * *before);
    set(b, turn.from);
    if (const auto start = last_.of_resting_machine(b)) b.set(start_, *start);
    put_tool(b, length * *after);
    return true;
  }

  void put_tool(ig::Block& b, const ig::Vec3& offset) const {
    Mat4 m = identity_frame;
    for (std::size_t i = 0; i < 3; ++i) m[12 + i] = offset[i];
    b.set_moving_transform(tool_, m);
  }

  /// A vector of the workpiece in coordinates of the tilted plane.
  ig::Vec3 unturned(const ig::Block& b, const ig::Vec3& way) const {
    const Mat4 m = tilt_.get(b);
    ig::Vec3 out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = dot(way, {m[4 * i], m[4 * i + 1], m[4 * i + 2]});
    return out;
  }
};

const ig::Register<PivotTransformation> pivot_transformation_syntax;

}  // namespace
}  // namespace iso
