/// G43.4 and G43.5: X Y Z are positions of the tool's tip in the workpiece, wherever the rotary axes have turned it.
/// The tool length lies along the tool axis. A block of G43.4 gives the angles, and a block of G43.5 the direction of
/// the tool (I J K), from which this syntax computes the angles; PivotTransformationSyntax turns the tool and the frame
/// with the axes. Fanuc manual, "Tool center point control".
#include <isogloss/cnc/cycle_codes.hpp>
#include <isogloss/cnc/motion_event.hpp>
#include <isogloss/cnc/rotary_solver.hpp>
#include <isogloss/cnc/rotary_turns.hpp>
#include <isogloss/sdk.hpp>

#include "five_axis/work_offset_frame.hpp"
#include "reading/as_written.hpp"
#include "tool/tool_length.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class RefusedCodes { said, executed };

struct ToolCenterPoint {
  static constexpr auto spec =
      ig::syntax("ToolCenterPointSyntax", "G43.4/G43.5 tool centre point control.")
          .after("ParameterizedFlagSyntax", "UnitModeSyntax", "PositioningModeSyntax", "IsoG68RotationSyntax",
                 "IsoG68p2TiltSyntax", "G53p1RotaryPositionSyntax")
          .before("ToolHeightOffsetSyntax", "IsoLocalCoordinateOffsetSyntax", "IsoCoordinateOffsetSyntax",
                  "WorkCoordinateShiftSyntax", "PivotTransformationSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0445",
                     "{0} under {1} is executed, but the control may refuse it: cancel {1} first"),
      ig::diagnostic(IG_ERROR, "ISO-0447",
                     "{0}: the rotary axes of the machine are not described, so the tool tip does not follow them"),
      ig::diagnostic(IG_ERROR, "ISO-0450", "I0 J0 K0 is not a direction, so the tool direction does not change"),
      ig::diagnostic(IG_ERROR, "ISO-0451",
                     "rotary words under G43.5 are not executed: program I, J and K instead, or use G43.4"),
      ig::diagnostic(IG_ERROR, "ISO-0454",
                     "I, J and K of an arc under G43.5 give no tool direction: program R, or use G43.4"),
  };

  ig::Call codes_{{"G43.4", "G43.5"}, "H[]"};
  ig::Call others_{{"G43", "G44", "G49"}, "", ig::read | ig::wake};
  ig::Call g43_{{"G43"}, "H[]", ig::read | ig::write};
  ig::InWhile<ig::Symbol> by_direction_{"ToolHeightCompensation.Term", "G43.5"};
  ig::Out<ig::Symbol> term_{"ToolHeightCompensation.Term"};
  ig::Out<std::int64_t> offset_id_{"ToolHeightCompensation.OffsetId"};
  ig::Out<double> offset_{"ToolHeightCompensation.Offset_mm"};
  ig::Out<double> untravelled_{"ToolHeightCompensation.Untravelled_mm"};
  ig::Signal table_changed_{"ToolHeightCompensation.~TableChanged", ig::read | ig::wake};
  ig::In<double> delta_{"ToolHeightCompensation.Delta_mm",
                        ig::read,
                        {ig::Life::modal, "mm", "What the tool call adds to the length of the table."}};
  ig::Transform frame_{"ToolHeightCompensation"};
  ig::Xyz orientation_{"ToolOrientation", ig::read | ig::write};
  ig::Field<bool> aligned_{"TiltTransform.IsAligned",
                           ig::read,
                           {ig::Life::modal, "", "G53.1 or G53.6 has put the tool upright on the plane."}};
  ig::Word h_{"Parsing.H", ig::wake, ""};
  std::array<ig::Word, 3> direction_{ig::Word{"Parsing.I", ig::take}, ig::Word{"Parsing.J", ig::take},
                                     ig::Word{"Parsing.K", ig::take}};
  std::array<ig::Word, 3> rotary_{ig::Word{"Parsing.A", ig::take, "deg"}, ig::Word{"Parsing.B", ig::take, "deg"},
                                  ig::Word{"Parsing.C", ig::take, "deg"}};
  std::array<ig::Out<double>, 3> axes_{ig::Out<double>{"MachineCoordinate.A"}, ig::Out<double>{"MachineCoordinate.B"},
                                       ig::Out<double>{"MachineCoordinate.C"}};
  ig::Codes excluded_{{"G33", "G53", "G54", "G55", "G56", "G57", "G58", "G59"}, ig::read | ig::wake};
  CycleCalls excluded_calls_{
      "",
      ig::read | ig::wake,
      {"G27", "G28", "G29", "G30", "G52", "G54.1", "G68", "G68.2", "G68.3", "G68.4", "G92", "G92.1"}};
  ig::Signal said_{"ToolCenterPoint.~Said", ig::read | ig::write, ig::Life::modal};
  MotionGroup group_;
  PlaneInMachine tilt_;
  ToolLengths lengths_{ig::Need::optional};
  ToolCenterMode mode_;
  RotaryTurns turn_{ig::read | ig::write, RotaryWordsAre::of_program};
  RotarySolver solver_;
  ToolKinematics machine_;
  ig::Name g43_4_{"G43.4"}, g43_5_{"G43.5"};
  ig::Choice<RefusedCodes> refused_{
      "refused-codes", "said|executed", "said",
      "Functions that a Fanuc control refuses under tool centre point control: executed with or without a warning."};
  ig::Choice<SolutionChoice> choice_{"choice", solution_choices, "min-sum",
                                     "Which solution G43.5 uses: see G53p1RotaryPositionSyntax."};

  ig::Status build(ig::Block& b) {
    const bool was_on = machine_ && mode_.is_on(b);
    const auto named = b.find(codes_), other = b.find(others_);
    if (!named && !was_on) return ig::Status::unchanged;
    const bool starts = named && (!other || ordinal(b, codes_.code(*named)) > ordinal(b, others_.code(*other)));
    const auto where = named ? ig::Where::word(codes_.code(*named)) : ig::Where::block();
    std::optional<double> h;
    if (named) {
      if (other) b.report(ig::diag("ISO-0201"), where, b.text(starts ? codes_.name(*named) : others_.name(*other)));
      h = (*b.take(codes_))['H'];
    }
    if (starts && !machine_) return as_g43(b, *named, h, where);
    if (!starts && other) {  // ToolHeightOffsetSyntax applies the length again
      if (was_on && !b.has(aligned_))
        for (std::size_t i = 0; i < 3; ++i) b.erase(orientation_.id(i));
      return ig::Status::changed;
    }
    if (const auto own = b.take(h_)) h = own;
    if (starts) {
      b.set(term_, codes_.name(*named));
      b.erase(untravelled_);
    }
    if (was_on && refused_ == RefusedCodes::said) report_excluded(b);
    const Angles from = turn_.read(b, machine_).from;
    const bool takes = b.is(term_, g43_5_) && turn_to_direction(b, from);
    return put_length(b, from, starts, h, where) || takes ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  static std::int64_t ordinal(const ig::Block& b, ig_field code) {
    ig_value v;
    return b.get(code, v) ? v.integer : 0;
  }

  ig::Status as_g43(ig::Block& b, std::size_t code, std::optional<double> h, ig::Where where) const {
    if (!b.is_raised(said_)) b.report(ig::diag("ISO-0447"), where, as_written(b, codes_.code(code), codes_.name(code)));
    b.raise(said_);
    b.set_call(g43_, 0);
    if (h) b.set_word(g43_, 0, 'H', *h);
    return ig::Status::changed;
  }

  void report_excluded(ig::Block& b) const {
    const auto report = [&](ig_field code, ig::Symbol name) {
      b.report(ig::diag("ISO-0445"), ig::Where::word(code), b.text(name), b.text(mode_.term(b)));
    };
    if (const auto code = b.find(excluded_)) report(excluded_.id(*code), excluded_.name(*code));
    if (const auto code = b.find(excluded_calls_)) report(excluded_calls_.code(*code), excluded_calls_.name(*code));
  }

  /// A new length goes along the tool axis that the block starts with.
  bool put_length(ig::Block& b, const Angles& from, bool starts, std::optional<double> h, ig::Where where) const {
    if (h)
      if (const auto row = ToolLengths::row(b, *h, where)) b.set(offset_id_, *row);
    if (starts && !b.has(offset_id_)) {
      b.report(ig::diag("ISO-0224"), where, b.text(mode_.term(b)));
      b.set(offset_id_, std::int64_t{0});
    }
    const bool looks_up = starts || h || b.is_raised(table_changed_);
    if (!looks_up) return false;
    b.set(offset_, lengths_.length(b, b.get_or(offset_id_, std::int64_t{0}), where) + b.get_or(delta_, 0.0));
    if (const auto axis = machine_.tool_axis(from)) {
      b.set(orientation_, *axis);
      b.set_translation(frame_, b.get_or(offset_, 0.0) * *axis);
    }
    return true;
  }

  /// G43.5: the angles that give the tool the direction of I J K. True when the block named a direction.
  bool turn_to_direction(ig::Block& b, const Angles& from) const {
    bool has_rotary = false, has_direction = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (machine_.has(axis) && b.take(rotary_[axis])) has_rotary = true;
    for (const ig::Word& word : direction_) has_direction = has_direction || b.has(word);
    if (has_rotary) b.report(ig::diag("ISO-0451"), ig::Where::block());

    const auto wanted = has_direction ? direction(b) : std::nullopt;
    if (!wanted) return has_rotary || has_direction;
    const RotaryCandidates found =
        solver_.candidates(machine_, *wanted, from, RotarySolver::sign_of(machine_, choice_));
    const auto angles = solver_.choose(machine_, found, from, choice_);
    if (!angles) {
      if (found.is_reachable)
        b.report(ig::diag("ISO-0444"), ig::Where::block(), b.text(static_cast<ig::Symbol>(g43_5_)));
      else
        b.report(ig::diag("ISO-0443"), ig::Where::block(), b.text(static_cast<ig::Symbol>(g43_5_)), wanted->x,
                 wanted->y, wanted->z);
      b.alarm();
      return true;
    }
    turn_.state().set(b, machine_, from);
    for (std::size_t k = 0; k < machine_.count(); ++k) b.set(axes_[machine_.axis(k)], (*angles)[machine_.axis(k)]);
    return true;
  }

  /// The unit vector of I J K in the workpiece; nothing, with a diagnostic, where they give no direction.
  std::optional<ig::Vec3> direction(ig::Block& b) const {
    std::uint32_t found = 0;
    const std::size_t code = group_.find(b, found).value_or(group_.in_force(b));
    if (code == MotionGroup::g02 || code == MotionGroup::g03) {
      b.report(ig::diag("ISO-0454"), ig::Where::block());
      return std::nullopt;
    }
    ig::Vec3 v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = b.take(direction_[i]).value_or(0.0);
    const double longest = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
    if (!(longest > 0) || !std::isfinite(longest)) {
      b.report(ig::diag("ISO-0450"), ig::Where::block());
      return std::nullopt;
    }
    v = (1 / longest) * v;  // avoids the overflow of the square of a huge number
    v = (1 / std::sqrt(dot(v, v))) * v;
    const Mat4 m = tilt_.get(b);
    return ig::Vec3{v.x * m[0] + v.y * m[4] + v.z * m[8], v.x * m[1] + v.y * m[5] + v.z * m[9],
                    v.x * m[2] + v.y * m[6] + v.z * m[10]};
  }
};

const ig::Register<ToolCenterPoint> tool_center_point_syntax;

}  // namespace
}  // namespace iso
