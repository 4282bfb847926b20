/// G00 and G01: the block that wrote a machine point goes there on a straight line, by rapid or by feed. The code stays
/// in force until another one of group 01.
#include "motion_event_util.hpp"
#include "program_xyz_util.hpp"

namespace iso {
namespace {

struct LinearMotion {
  static constexpr auto spec = ig::syntax("LinearMotionSyntax", "G00/G01 straight motion.")
                                   .after("FeedrateSyntax", "McXyzSyntax", "CircularMotionSyntax")
                                   .before("ReferenceReturnSyntax")
                                   .first_writer("Motion");

  ig::Codes straight_{{"G00", "G01"}, ig::wake};
  ig::Xyz machine_{"MachineCoordinate", ig::read | ig::wake};
  ig::Xyz program_{"ProgramXyz", ig::read};
  MotionGroup group_;
  BlockMotion motion_;
  LastProgramXyz last_;

  ig::Status build(ig::Block& b) {
    if (group_.is_answered(b)) return ig::Status::unchanged;
    std::uint32_t found = 0;
    const auto named = group_.find(b, found);
    const std::size_t code = named ? *named : group_.in_force(b);
    if (code > MotionGroup::g01) return ig::Status::unchanged;
    const bool moves = b.is_fresh(machine_) && !motion_.is_moving(b);
    if (named)
      group_.take(b, code, found);
    else if (moves)
      group_.put_in_force(b, code);
    else
      return ig::Status::unchanged;
    if (!moves) return ig::Status::changed;

    if (code == MotionGroup::g00)
      motion_.rapid(b);
    else
      motion_.feed(b, [&] { return length(b.get(program_).or_else({}) - last_(b)); });
    return ig::Status::changed;
  }
};

const ig::Register<LinearMotion> registered;

}  // namespace
}  // namespace iso
