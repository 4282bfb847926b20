// MB of PLANE … TURN: the tool retracts along Z of the machine, then the rotary axes turn. The block moves twice, so
// its move becomes two steps.
#include <isogloss/cnc/event_to_steps.hpp>
#include <isogloss/cnc/rotary_words.hpp>
#include <isogloss/sdk.hpp>

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextPlaneRetract {
  static constexpr auto spec =
      ig::syntax("KlartextPlaneRetractSyntax", "PLANE … TURN MB: the retract before the axes turn.")
          .after("KlartextPlaneSyntax", "McXyzSyntax", "McAbcSyntax", "LinearMotionSyntax")
          .before("TravelCheckSyntax");

  ig::In<double> distance_{"KlartextPlane.Retract_mm",
                           ig::wake,
                           {ig::Life::block, "mm", "MB: how far the tool goes out before the axes turn."}};
  ig::In<bool> to_limit_{"KlartextPlane.RetractsToLimit",
                         ig::wake,
                         {ig::Life::block, "", "MB MAX: the tool goes out to the end of the travel."}};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::Xyz machine_{"MachineCoordinate", ig::read | ig::write};
  ig::Xyz program_{"ProgramXyz", ig::read | ig::write};
  ig::Out<ig::Symbol> compound_{"CompoundMotion.Term"};
  ig::In<ig::Symbol> motion_code_{"MotionState.Term"};
  ig::Service<ig_machine_axis_1> axes_{"isogloss.machine-axis/1", ig::Need::optional, "The travel of Z, for MB MAX."};
  RotaryPosition rotary_{ig::read};
  EventToSteps event_;
  ToolSteps steps_;

  ig::Status build(ig::Block& b) const {
    if (!b.has(distance_) && !b.has(to_limit_)) return ig::Status::unchanged;
    const ig::PartialVec3 here = b.get(machine_);
    double minimum = 0, maximum = 0;
    const bool is_known = axes_ && axes_->travel(axes_->self, 'Z', &minimum, &maximum) != 0;
    if (!here.complete() || !b.has(form_) || (b.has(to_limit_) && !is_known)) {
      b.report(ig::diag("HEI-0171"), ig::Where::block(), std::string_view("MB"),
               std::string_view("where the travel of the tool axis ends is not known, and nothing retracts"));
      return ig::Status::unchanged;
    }
    ig::Vec3 out = here.value;
    const double way = b.get(distance_).value_or(maximum - out.z);
    out.z += is_known ? std::fmin(way, std::fmax(0, maximum - out.z)) : way;
    const auto program = b.to_program(out);
    if (!program) return ig::Status::unchanged;
    const ToolSteps::Manner manner = event_.take(b);
    const std::uint32_t turned = rotary_.fresh(b);
    PartialAngles rotary = rotary_.get(b);
    rotary.mask &= turned;
    b.set(machine_, out);
    b.set(program_, *program);
    steps_.line(b, *program, manner);
    steps_.line(b, *program, manner);
    steps_.finish(b, rotary);
    if (const auto code = b.get(motion_code_)) b.set(compound_, *code);
    return ig::Status::changed;
  }
};

const ig::Register<KlartextPlaneRetract> klartext_plane_retract_syntax;

}  // namespace
}  // namespace heidenhain
