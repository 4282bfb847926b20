/// G76: bore to the bottom, stop the spindle at its angle, move the tip off the wall, and retract by rapid, so that the
/// finished bore gets no mark.
///
/// Carries out the call that CannedCycleResolveSyntax has resolved. Every step is an item of the motion, even one of
/// length 0.
#include <string>

#include <isogloss/cnc/restarted_spindle.hpp>

#include "cycles/single_stroke.hpp"
#include "cycles/tool_shift.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct FineBoring {
  static constexpr auto spec =
      ig::syntax("FineBoringSyntax", "G76 fine boring: oriented stop and shift before the retract.")
          .after("CannedCycleResolveSyntax", "SpindleSpeedSyntax")
          .before("IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");

  enum class Dwell { none, bottom };

  CannedCycle cycle_{"G76"};
  CycleDwell dwell_;
  RestartedSpindle spindle_;
  ToolShift shift_;
  ig::Choice<Dwell> dwell_at_{"dwell", "none|bottom", "none", "Where P waits."};

  ig::Status build(ig::Block& b) {
    auto run = cycle_.take(b);
    if (!run) return ig::Status::unchanged;
    limit_steps(b, *run, 9);
    const double feed = cycle_.stroke_feed(b, std::fabs(run->r_level - run->bottom));
    const double dwell = dwell_at_ == Dwell::bottom ? dwell_.seconds(*run) : 0;
    const ToolShift::Shift shift = shift_.of(b, *run);
    const std::string_view dwells = dwell_at_ == Dwell::none ? "" : "P";
    cycle_.report_unused(b, *run, std::string(dwells).append(shift_.used_words(*run)));
    const ig::CompoundMotion& motion = cycle_.motion;
    const auto start = spindle_.begin(b, motion, cycle_.where(*run), run->code);
    ig::CompoundSteps steps(b, motion);

    for (int i = 0; i < run->count; ++i) {
      const CycleHole hole = run->hole(i);
      feed_to_bottom(steps, *run, hole, {feed, dwell});
      steps.flush();
      shift_.retract(b, motion, hole, shift, run->bottom, run->return_level, feed, start);
    }
    cycle_.end(b, *run);
    return ig::Status::changed;
  }
};

const ig::Register<FineBoring> fine_boring_syntax;

}  // namespace
}  // namespace iso
