/// CYCLE81 and CYCLE82: rapid to the safety distance, feed to the depth, wait there, rapid to the retract plane.
#include "drilling_cycle.hpp"

namespace siemens {
namespace {

struct SiemensDrillingCycle {
  static constexpr auto spec = ig::syntax("SiemensDrillingCycleSyntax", "CYCLE81/CYCLE82 drilling, rapid retract.")
                                   .after("SiemensCycleSyntax", "FeedrateSyntax")
                                   .before("ProgramXyzSyntax", "McXyzSyntax", "LinearMotionSyntax");

  DrillingCall cycle_{0, 2};

  ig::Status build(ig::Block& b) {
    const auto run = cycle_.take(b);
    if (!run) return ig::Status::changed;
    const ig::CompoundMotion& motion = cycle_.motion;
    motion.rapid_to(b, run->at(run->start));
    motion.feed_to(b, run->at(run->depth), run->feed);
    if (run->dwell > 0) motion.dwell(b, run->dwell);
    motion.rapid_to(b, run->at(run->retract));
    cycle_.end(b, *run);
    return ig::Status::changed;
  }
};

const ig::Register<SiemensDrillingCycle> registered;

}  // namespace
}  // namespace siemens
