/// G88: bore to the bottom by feed, dwell (P), stop the spindle; then the operator retracts the tool by hand. On some
/// controls G87 is the same without the dwell.
///
/// Carries out the call that CannedCycleResolveSyntax has resolved. The operator's retract is a rapid to R, marked as
/// manual. Every step is an item of the motion, even one of length 0.
#include <isogloss/cnc/restarted_spindle.hpp>

#include "cycles/single_stroke.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct ManualBoringCycle {
  static constexpr auto spec = ig::syntax("ManualBoringCycleSyntax", "G88 boring cycle: the operator retracts by hand.")
                                   .after("SpindleSpeedSyntax", "CannedCycleResolveSyntax")
                                   .before("IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_NOTE, "ISO-0335", "{0}: the control waits for the operator at the bottom of the hole"),
  };

  enum class Codes { g88, g87_g88 };

  ig::Choice<Codes> codes_{"codes", "G88|G87-G88", "G88",
                           "G88 alone, or also G87, which does not wait for the operator."};
  CannedCycle g88_alone_{"G88"}, both_{"G88", "G87"};
  const CannedCycle& cycle_ = codes_ == Codes::g88 ? g88_alone_ : both_;
  ig::Name g88_{"G88"};
  CycleDwell dwell_;
  RestartedSpindle spindle_;
  ig::ManualMotion by_hand_;
  ig::Previous<ig::Symbol> term_before_{"CannedCycle.Term"};

  ig::Status build(ig::Block& b) {
    const auto run = cycle_.take(b);
    if (!run) return ig::Status::unchanged;
    const double feed = cycle_.stroke_feed(b, std::fabs(run->r_level - run->bottom));
    const double dwell = run->code == g88_ ? dwell_.seconds(*run) : 0;
    cycle_.report_unused(b, *run, run->code == g88_ ? "P" : "");
    if (!b.is(term_before_, run->code)) b.report(ig::diag("ISO-0335"), cycle_.where(*run), b.text(run->code));
    const auto start = spindle_.begin(b, cycle_.motion, cycle_.where(*run), run->code);
    ig::CompoundSteps steps(b, cycle_.motion);

    for (int i = 0; i < run->count; ++i) {
      const CycleHole hole = run->hole(i);
      feed_to_bottom(steps, *run, hole, {feed, dwell});
      steps.spindle(ig::Spindle::stop);
      by_hand_.rapid_to(b, hole.at(run->r_level));
      steps.spindle(start);
      if (run->returns_to_initial) steps.rapid_to(hole.at(run->return_level));
    }
    cycle_.end(b, *run);
    return ig::Status::changed;
  }
};

const ig::Register<ManualBoringCycle> manual_boring_cycle_syntax;

}  // namespace
}  // namespace iso
