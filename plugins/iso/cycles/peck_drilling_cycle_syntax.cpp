/// G83: drill in pecks of Q and retract to R after each peck, so that the chips come out.
///
/// Carries out the call that CannedCycleResolveSyntax has resolved. Every step is an item of the motion, even one of
/// length 0.
#include "cycles/peck_cycle_util.hpp"

namespace iso {
namespace {

struct PeckDrillingCycle {
  static constexpr auto spec =
      ig::syntax("PeckDrillingCycleSyntax", "G83 peck drilling cycle: back to R after each peck.")
          .after("CannedCycleResolveSyntax")
          .before("IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");

  CannedCycle cycle_{"G83"};
  PeckCycle pecks_{"PeckRetractionDistance_mm"};
  PeckDwell dwell_;
  enum class LastRetract { via_r, direct };
  ig::Choice<LastRetract> last_retract_{
      "last-retract", "via-r|direct", "via-r",
      "The retract after the last peck: to R and then to the return level, or directly to the return level."};

  ig::Status build(ig::Block& b) {
    const auto run = cycle_.take(b);
    if (!run) return ig::Status::unchanged;
    const auto pecks = pecks_.plan(b, cycle_, *run);
    const double feed = pecks ? cycle_.stroke_feed(b, std::fabs(run->r_level - run->bottom)) : 0;
    const bool waits = dwell_.is_used();
    cycle_.report_unused(b, *run, pecks_.used(*run, waits ? "QP" : "Q", waits ? "IJKP" : "IJK"));
    ig::CompoundSteps steps(b, cycle_.motion);

    for (int i = 0; i < run->count; ++i) {
      const CycleHole hole = run->hole(i);
      steps.rapid_to(hole.at(hole.approach_level));
      if (pecks) {
        steps.rapid_to(hole.at(run->r_level));
        for (int k = 1; k <= pecks->count; ++k) {
          if (k > 1) steps.rapid_to(hole.at(pecks->clear_of(k - 1)));
          steps.feed_to(hole.at(pecks->level(k)), feed);
          dwell_.dwell(steps, *run, pecks->is_last(k));
          if (!pecks->is_last(k))
            steps.rapid_to(hole.at(pecks->clear_level));
          else if (last_retract_ == LastRetract::via_r)
            steps.rapid_to(hole.at(run->r_level));
        }
      }
      steps.rapid_to(hole.at(run->return_level));
    }
    cycle_.end(b, *run);
    return ig::Status::changed;
  }
};

const ig::Register<PeckDrillingCycle> peck_drilling_cycle_syntax;

}  // namespace
}  // namespace iso
