/// G00 and G01: the block goes to its machine point on a straight line, by rapid or by feed. The code stays in force
/// until another code of group 01.
#include "motion/turning_feed.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct LinearMotion {
  static constexpr auto spec = ig::syntax("LinearMotionSyntax", "G00/G01 straight motion.")
                                   .after("FeedrateSyntax", "McXyzSyntax", "CircularMotionSyntax")
                                   .before("ReferenceReturnSyntax")
                                   .first_writer("Motion");

  ig::Codes straight_{{"G00", "G01"}, ig::wake};
  ig::Xyz machine_{"MachineCoordinate", ig::read | ig::wake};
  ig::Xyz program_{"ProgramXyz", ig::read};
  TurningFeed turning_;
  ig::Choice<FeedCounts> feed_counts_{"feed-counts", "linear-axes|all-axes", "linear-axes",
                                      "Which motion F sets the speed of, in a block that moves X Y Z and rotary axes."};
  MotionGroup group_;
  BlockMotion motion_;
  LastProgramXyz last_;

  // Most blocks come here: whether the call is inlined must not depend on the other files of the unity batch.
  [[gnu::always_inline]] ig::Status build(ig::Block& b) {
    if (group_.is_answered(b)) return ig::Status::unchanged;
    std::uint32_t found = 0;
    const auto named = group_.find(b, found);
    const std::size_t code = named ? *named : group_.in_force(b);
    if (code > MotionGroup::g01) return ig::Status::unchanged;
    const bool moves = b.is_fresh(machine_) && !motion_.is_moving(b);
    if (!moves) {
      if (!named) return ig::Status::unchanged;
      group_.take(b, code, found);
      return ig::Status::changed;
    }
    if (named) group_.take_codes(b, code, found);
    const MotionGroup::Entry in_force = group_.entry(code);
    if (code == MotionGroup::g00)
      motion_.rapid(b, in_force);
    else if (turning_.turns(b))
      turning_.feed(b, motion_, way(b), feed_counts_, in_force);
    else
      motion_.feed(
          b, [&] { return way(b); }, in_force);
    return ig::Status::changed;
  }

 private:
  double way(ig::Block& b) const { return length(b.get(program_).or_else({}) - last_(b)); }
};

const ig::Register<LinearMotion> linear_motion_syntax;

}  // namespace
}  // namespace iso
