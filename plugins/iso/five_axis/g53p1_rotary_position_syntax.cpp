/// G53.1 and G53.6: the rotary axes turn the tool square to the tilted work plane in force. Under G53.1 the machine's X
/// Y Z do not move; under G53.6 the tip of the tool stays on the workpiece. Fanuc manual, "Tool axis direction
/// control".
#include <isogloss/cnc/motion_event.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/rotary_solver.hpp>
#include <isogloss/cnc/rotary_turns.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

#include "five_axis/work_offset_frame.hpp"
#include "reading/as_written.hpp"
#include "tool/tool_length.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class RotaryMotion { modal, rapid };
enum class UnreachableP { alarm, alternative };
enum class CenterSide { beyond_tip, towards_holder };

struct G53p1RotaryPosition {
  static constexpr auto spec =
      ig::syntax("G53p1RotaryPositionSyntax", "G53.1/G53.6: turns the tool perpendicular to the tilted work plane.")
          .after("ParameterizedFlagSyntax", "UnitModeSyntax", "PositioningModeSyntax", "IsoG68RotationSyntax",
                 "IsoG68p2TiltSyntax")
          .before("ToolCenterPointSyntax", "ToolHeightOffsetSyntax", "PivotTransformationSyntax", "ProgramXyzSyntax",
                  "McXyzSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0441", "{0} without a tilted work plane: the rotary axes do not move"),
      ig::diagnostic(IG_ERROR, "ISO-0442",
                     "{0}: the rotary axes of the machine are not described, so nothing turns: give --machine FILE"),
      ig::diagnostic(IG_ERROR, "ISO-0448", "{0} needs a block of its own: X, Y and Z beside it are not executed"),
      ig::diagnostic(IG_WARNING, "ISO-0449",
                     "the tool is not perpendicular to the tilted work plane: it leans by {0} degrees"),
      ig::diagnostic(IG_ERROR, "ISO-0452",
                     "{0} is not executed under {1}, so the rotary axes do not move: cancel {1} first"),
      ig::diagnostic(IG_ERROR, "ISO-0453", "{0} P{1}: P must be 0, 1 or 2, so the rotary axes do not move"),
  };

  ig::Call codes_{{"G53.1", "G53.6"}, "P[] H[] R"};
  ig::Field<bool> aligned_{"TiltTransform.IsAligned",
                           ig::read | ig::write | ig::wake_while,
                           {ig::Life::modal, "", "G53.1 or G53.6 has put the tool upright on the plane."}};
  ig::In<ig::Symbol> tilt_term_{"TiltTransform.Term"};
  PlaneInMachine tilt_;
  ig::Xyz orientation_{"ToolOrientation", ig::write};
  ig::Xyz machine_xyz_{"MachineCoordinate", ig::read | ig::write};
  std::array<ig::Out<double>, 3> axes_{ig::Out<double>{"MachineCoordinate.A"}, ig::Out<double>{"MachineCoordinate.B"},
                                       ig::Out<double>{"MachineCoordinate.C"}};
  ig::Xyz words_{"Parsing", ig::take};
  std::array<ig::Word, 3> rotary_{ig::Word{"Parsing.A", ig::take, "deg"}, ig::Word{"Parsing.B", ig::take, "deg"},
                                  ig::Word{"Parsing.C", ig::take, "deg"}};
  ig::In<double> length_{"ToolHeightCompensation.Offset_mm"};
  ig::Field<double> lever_{"PivotTransform.Lever_mm",
                           ig::write,
                           {ig::Life::block, "mm", "How far beyond the tip the point lies that rests under G53.6."}};
  ig::Signal tip_stays_{"PivotTransform.~TipStays", ig::write};
  ig::Signal turns_{"PivotTransform.~Turns", ig::write};
  ig::Signal said_{"G53p1RotaryPosition.~Said", ig::read | ig::write, ig::Life::modal};
  ToolLengths lengths_{ig::Need::optional};
  MotionGroup group_;
  BlockMotion move_;
  ToolCenterMode mode_;
  RotaryTurns turn_{ig::read | ig::write, RotaryWordsAre::of_program};
  RotarySolver solver_;
  ToolKinematics machine_;
  ig::Name g68_2_{"G68.2"}, g68_3_{"G68.3"}, g68_4_{"G68.4"};

  ig::Choice<RotaryMotion> motion_{
      "motion", "modal|rapid", "modal",
      "How the axes move: by the code of group 01 (by rapid under an arc or a thread), or always by rapid."};
  ig::Choice<SolutionChoice> choice_{
      "choice", solution_choices, "min-first",
      "The solution without P: smallest travel of the first axis, of both together, or of the axis that travels "
      "farther; the first axis at 0 or positive, or at 0 or negative."};
  ig::Choice<UnreachableP> unreachable_p_{
      "unreachable-p", "alarm|alternative", "alarm",
      "What happens if the solution of P is outside the travel: an alarm, or the other solution."};
  ig::Choice<CenterSide> center_side_{"center-side", "beyond-tip|towards-holder", "beyond-tip",
                                      "Where the resting point of a G53.6 with R is, at the distance R from the tip."};

  ig::Status build(ig::Block& b) {
    const auto call = b.take(codes_);
    if (!call) return follow(b);
    const auto where = ig::Where::word(codes_.code(call->row));
    if (b.take(words_).mask != 0) b.report(ig::diag("ISO-0448"), where, b.text(call->code));
    if (is_refused(b, *call, where)) return ig::Status::changed;

    const ig::Vec3 normal = plane_normal(b);
    const RotaryTurn turn = turn_.read(b, machine_);
    const PartialAngles present = turn_.angles().present(b);
    const auto angles = target(b, *call, normal, present.value, where);
    if (!angles) return ig::Status::changed;

    const bool keeps_tip = call->row == g53_6;
    if (keeps_tip) lead(b, *call, present.value, *angles, turn, where);
    for (std::size_t k = 0; k < machine_.count(); ++k) b.set(axes_[machine_.axis(k)], (*angles)[machine_.axis(k)]);
    if (!keeps_tip) {
      const ig::PartialVec3 stays = b.get(machine_xyz_);
      if (stays.complete()) b.set(machine_xyz_, stays.value);
    }
    b.set(aligned_, true);
    set_orientation(b, *angles, normal);
    if (motion_ == RotaryMotion::rapid || !is_straight(b)) move_.rapid(b);
    return ig::Status::changed;
  }

 private:
  enum Row : std::size_t { g53_1, g53_6 };

  bool is_straight(const ig::Block& b) const {
    std::uint32_t found = 0;
    return group_.find(b, found).value_or(group_.in_force(b)) <= MotionGroup::g01;
  }
  bool is_tilted(const ig::Block& b) const {
    return b.is(tilt_term_, g68_2_) || b.is(tilt_term_, g68_3_) || b.is(tilt_term_, g68_4_);
  }

  std::string_view written(const ig::Block& b, const ig::Words& call) const {
    return as_written(b, codes_.code(call.row), call.code);
  }

  /// Reports a block without a tilted plane, under tool centre point control, or without machine kinematics. The code
  /// then has no effect; the rest of the block is executed.
  bool is_refused(ig::Block& b, const ig::Words& call, ig::Where where) const {
    const std::string_view code = written(b, call);
    if (!is_tilted(b)) {
      b.report(ig::diag("ISO-0441"), where, code);
    } else if (!machine_) {
      if (!b.is_raised(said_)) b.report(ig::diag("ISO-0442"), where, code);
      b.raise(said_);
    } else if (mode_.is_on(b)) {
      b.report(ig::diag("ISO-0452"), where, code, b.text(mode_.term(b)));
    } else {
      return false;
    }
    return true;
  }

  ig::Vec3 plane_normal(const ig::Block& b) const {
    const Mat4 m = tilt_.get(b);
    const ig::Vec3 z{m[8], m[9], m[10]};
    return (1 / std::sqrt(dot(z, z))) * z;
  }

  std::optional<Angles> target(ig::Block& b, const ig::Words& call, const ig::Vec3& normal, const Angles& present,
                               ig::Where where) const {
    const double p = call['P'].value_or(0);
    const SolutionChoice choice = p == 1 ? SolutionChoice::positive : p == 2 ? SolutionChoice::negative : choice_;
    if (p != 0 && p != 1 && p != 2) {
      b.report(ig::diag("ISO-0453"), where, b.text(call.code), p);
      return std::nullopt;
    }
    const PartialAngles wanted = take_rotary(b, present);
    RotaryCandidates found = solver_.candidates(machine_, normal, present, RotarySolver::sign_of(machine_, choice));
    if (wanted.mask != 0) return by_words(found, wanted, present, choice);
    auto angles = solver_.choose(machine_, found, present, choice);
    if (!angles && p != 0 && unreachable_p_ == UnreachableP::alternative)
      angles = solver_.choose(machine_, found, present, SolutionChoice::min_first);
    if (angles) return angles;
    if (found.is_reachable)
      b.report(ig::diag("ISO-0444"), where, written(b, call));
    else
      b.report(ig::diag("ISO-0443"), where, written(b, call), normal.x, normal.y, normal.z);
    b.alarm();
    return std::nullopt;
  }

  /// Takes the words of the axes that turn the tool; words of other axes move as usual.
  PartialAngles take_rotary(ig::Block& b, const Angles& present) const {
    const Angles to = turn_.angles().target(b).value;
    PartialAngles out;
    for (std::size_t k = 0; k < machine_.count(); ++k) {
      const std::size_t axis = machine_.axis(k);
      if (!b.take(rotary_[axis])) continue;
      out.mask |= 1u << axis;
      const double angle = turn_.is_incremental(b) ? to[axis] : turn_.to_machine(b, axis, to[axis]);
      out.value[axis] = turn_.axes().approach(axis, present[axis], angle);
    }
    return out;
  }

  /// The programmed angles; for an axis without a word, the angle of the solution that agrees with them, if one does.
  std::optional<Angles> by_words(const RotaryCandidates& found, const PartialAngles& wanted, const Angles& present,
                                 SolutionChoice choice) const {
    constexpr double agrees_deg = 0.01;  // the precision to which programs round angles
    RotaryCandidates agreeing;
    for (std::size_t i = 0; i < found.count; ++i) {
      bool agrees = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
        agrees = agrees && (!wanted.has(axis) ||
                            std::fabs(std::remainder(found.angles[i][axis] - wanted.value[axis], 360)) <= agrees_deg);
      if (agrees) agreeing.angles[agreeing.count++] = found.angles[i];
    }
    auto base = solver_.choose(machine_, agreeing, present, choice);
    if (!base) base = solver_.choose(machine_, found, present, choice);
    return wanted.or_else(base.value_or(present));
  }

  /// For G53.6: tells PivotTransformationSyntax which point is at rest.
  void lead(ig::Block& b, const ig::Words& call, const Angles& from, const Angles& to, RotaryTurn turn,
            ig::Where where) const {
    turn.from = from;
    turn.to = to;
    turn_.state().set(b, machine_, from);
    b.raise(tip_stays_);
    if (turn_.moves(machine_, turn)) b.raise(turns_);
    const double in_force = b.get_or(length_, 0.0);
    double rests = call['R'].value_or(0);
    if (center_side_ == CenterSide::towards_holder) rests = -rests;
    if (const auto h = call['H'])
      if (const auto row = ToolLengths::row(b, *h, where)) rests += lengths_.length(b, *row, where) - in_force;
    if (rests != 0) b.set(lever_, rests);
  }

  /// The tool's orientation: the plane's normal itself where the tool is square to the plane, since the angles are
  /// rounded.
  void set_orientation(ig::Block& b, const Angles& angles, const ig::Vec3& normal) const {
    constexpr double upright_rad = 1e-6;
    const auto axis = machine_.tool_axis(angles);
    if (!axis) return;
    const ig::Vec3 off = *axis - normal;
    const double lean = std::sqrt(dot(off, off));
    b.set(orientation_, lean < 1e-9 ? normal : *axis);
    if (lean > upright_rad)
      b.report(ig::diag("ISO-0449"), ig::Where::block(), 2 * std::asin(std::fmin(lean / 2, 1)) * degrees_per_radian);
  }

  /// After G53.1: a rotary word leans the tool; when the plane ends, its direction ends too.
  ig::Status follow(ig::Block& b) const {
    if (mode_.is_on(b) || !machine_) return ig::Status::unchanged;
    if (!b.has(aligned_)) {
      for (std::size_t i = 0; i < 3; ++i) b.erase(orientation_.id(i));
      return ig::Status::changed;
    }
    const RotaryTurn turn = turn_.read(b, machine_);
    if (!turn.moves && !turn.was_moved) return ig::Status::unchanged;
    set_orientation(b, turn.to, plane_normal(b));
    return ig::Status::changed;
  }
};

const ig::Register<G53p1RotaryPosition> g53p1_rotary_position_syntax;

}  // namespace
}  // namespace iso
