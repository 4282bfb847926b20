/// G81 and G82: drill to the bottom in one stroke, retract by rapid. G82 dwells (P) at the bottom.
///
/// Carries out the call that CannedCycleResolveSyntax has resolved. Every step is an item of the motion, even one of
/// length 0.
#include <cmath>

#include "cycles/single_stroke.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct DrillingCycle {
  static constexpr auto spec = ig::syntax("DrillingCycleSyntax", "G81/G82 drilling cycle, rapid retract.")
                                   .after("CannedCycleResolveSyntax")
                                   .before("IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");

  CannedCycle cycle_{"G81", "G82"};
  CycleDwell dwell_;
  ig::Name g82_{"G82"};

  ig::Status build(ig::Block& b) {
    const auto run = cycle_.take(b);
    if (!run) return ig::Status::unchanged;
    const double feed = cycle_.stroke_feed(b, std::fabs(run->r_level - run->bottom));
    const double dwell = run->code == g82_ ? dwell_.seconds(*run) : 0;
    cycle_.report_unused(b, *run, run->code == g82_ ? "P" : "");
    ig::CompoundSteps steps(b, cycle_.motion);

    for (int i = 0; i < run->count; ++i) {
      const CycleHole hole = run->hole(i);
      feed_to_bottom(steps, *run, hole, {feed, dwell});
      steps.rapid_to(hole.at(run->return_level));
    }
    cycle_.end(b, *run);
    return ig::Status::changed;
  }
};

const ig::Register<DrillingCycle> drilling_cycle_syntax;

}  // namespace
}  // namespace iso
