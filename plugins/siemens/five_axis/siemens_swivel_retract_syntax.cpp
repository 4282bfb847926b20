// _FR of CYCLE800: the tool retracts by rapid, then the rotary axes turn. The block moves more than once, so its move
// becomes steps.
#include <isogloss/cnc/event_to_steps.hpp>
#include <isogloss/cnc/rotary_words.hpp>
#include <isogloss/sdk.hpp>

#include "five_axis/swivel_retract.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensSwivelRetract {
  static constexpr auto spec =
      ig::syntax("SiemensSwivelRetractSyntax", "CYCLE800 _FR: the retract before the axes turn.")
          .after("SiemensSwivelSyntax", "McXyzSyntax", "McAbcSyntax", "LinearMotionSyntax")
          .before("TravelCheckSyntax");

  SwivelRetractFields fields_{ig::read | ig::wake};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::Xyz machine_{"MachineCoordinate", ig::read | ig::write};
  ig::Xyz program_{"ProgramXyz", ig::read | ig::write};
  ig::Out<ig::Symbol> compound_{"CompoundMotion.Term"};
  ig::Name cycle_{"CYCLE800"};
  RotaryPosition rotary_{ig::read};
  EventToSteps event_;
  ToolSteps steps_;

  ig::Status build(ig::Block& b) const {
    const ig::PartialVec3 here = b.get(machine_), target = b.get(fields_.target);
    if (!here.complete() || !target.complete()) return ig::Status::unchanged;
    ig::Vec3 above = here.value;
    above.z = target.value.z;
    const auto first = b.to_program(above), last = b.to_program(target.value);
    if (!first || !last) return ig::Status::unchanged;
    const bool turns = b.has(form_);
    const std::uint32_t turned = rotary_.fresh(b);
    const ToolSteps::Manner turning = turns ? event_.take(b) : ToolSteps::Manner{};
    const ToolSteps::Manner rapid{true, std::nullopt, 0};
    if (b.get_or(fields_.z_first, false)) steps_.line(b, *first, rapid);
    steps_.line(b, *last, rapid);
    PartialAngles rotary = rotary_.get(b);
    rotary.mask &= turns ? turned : 0u;
    if (turns) steps_.line(b, *last, turning);
    b.set(machine_, target.value);
    b.set(program_, *last);
    steps_.finish(b, rotary);
    b.set(compound_, cycle_);
    return ig::Status::changed;
  }
};

const ig::Register<SiemensSwivelRetract> siemens_swivel_retract_syntax;

}  // namespace
}  // namespace siemens
