// G181: presses a dimple. The tool is fed to the bottom, waits there, and is fed out again with the same feed.
#include <isogloss/cnc/canned_cycle.hpp>

#include <cmath>

namespace {

using namespace ig::cnc;

struct AcmeDimpleCycle {
  static constexpr auto spec = ig::syntax("AcmeDimpleCycleSyntax", "G181 dimple: in and out by feed, with a wait.")
                                   .after("CannedCycleResolveSyntax")
                                   .before("IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");

  CannedCycle cycle_{"G181"};
  CycleDwell dwell_;

  ig::Status build(ig::Block& b) {
    const auto run = cycle_.take(b);
    if (!run) return ig::Status::unchanged;
    const double feed = cycle_.stroke_feed(b, std::fabs(run->r_level - run->bottom));
    const double dwell = dwell_.seconds(*run);
    cycle_.report_unused(b, *run, "P");
    const ig::CompoundMotion& motion = cycle_.motion;

    for (int i = 0; i < run->count; ++i) {
      const CycleHole hole = run->hole(i);
      motion.rapid_to(b, hole.at(hole.approach_level));
      motion.rapid_to(b, hole.at(run->r_level));
      motion.feed_to(b, hole.at(run->bottom), feed);
      if (dwell > 0) motion.dwell(b, dwell);
      motion.feed_to(b, hole.at(run->r_level), feed);
      motion.rapid_to(b, hole.at(run->return_level));
    }
    cycle_.end(b, *run);
    return ig::Status::changed;
  }
};

const ig::Register<AcmeDimpleCycle> acme_dimple_cycle_syntax;

}  // namespace
