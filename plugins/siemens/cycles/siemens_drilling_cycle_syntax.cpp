/// CYCLE81 and CYCLE82: rapid to the safety distance, feed to the depth, dwell there, rapid to the retract plane.
#include "cycles/drilling_cycle.hpp"

namespace siemens {
namespace {

struct SiemensDrillingCycle {
  static constexpr auto spec = ig::syntax("SiemensDrillingCycleSyntax", "CYCLE81/CYCLE82 drilling, rapid retract.")
                                   .after("SiemensCycleSyntax", "SiemensPatternCallSyntax", "FeedrateSyntax")
                                   .before("ProgramXyzSyntax", "McXyzSyntax", "LinearMotionSyntax");

  DrillingCall cycle_{"CYCLE81", "CYCLE82"};

  ig::Status build(ig::Block& b) {
    auto run = cycle_.take(b);
    if (!run) return ig::Status::changed;
    const ig::CompoundMotion& motion = cycle_.motion;
    cycle_.drill(b, *run, [&](const DrillingRun& hole) {
      motion.rapid_to(b, hole.at(hole.start));
      motion.feed_to(b, hole.at(hole.depth), hole.feed);
      if (hole.dwell > 0) motion.dwell(b, hole.dwell);
      motion.rapid_to(b, hole.at(hole.retract));
    });
    return ig::Status::changed;
  }
};

const ig::Register<SiemensDrillingCycle> siemens_drilling_cycle_syntax;

}  // namespace
}  // namespace siemens
