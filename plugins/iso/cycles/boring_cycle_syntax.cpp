/// G85, G86 and G89: bore to the bottom by feed. G85 leaves the hole by feed; G89 dwells (P) and leaves by feed; G86
/// stops the spindle, leaves by rapid and starts the spindle again.
///
/// Carries out the call that CannedCycleResolveSyntax has resolved. Every step is an item of the motion, even one of
/// length 0.
#include <isogloss/cnc/restarted_spindle.hpp>

#include "cycles/single_stroke.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class Retract { feed_to_final, feed_to_r };
enum class StopDwell { none, bottom };

struct BoringCycle {
  static constexpr auto spec = ig::syntax("BoringCycleSyntax", "G85/G86/G89 boring cycles.")
                                   .after("SpindleSpeedSyntax", "CannedCycleResolveSyntax")
                                   .before("IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");

  CannedCycle cycle_{"G85", "G86", "G89"};
  CycleDwell dwell_;
  RestartedSpindle spindle_;
  ig::Config config_{"isogloss.canned-cycle/1", ig::Need::optional, "BoringReturnOverride_percent"};
  ig::Choice<Retract> retract_{"retract", "feed-to-final|feed-to-r", "feed-to-final",
                               "How far G85 and G89 retract by feed: to the return level, or to R and then by rapid."};
  ig::Choice<StopDwell> g86_dwell_{"g86-dwell", "none|bottom", "none",
                                   "Whether P of G86 is a dwell time before the spindle stops."};
  ig::Name g86_{"G86"}, g89_{"G89"};
  double return_override_ = override_of(config_.number("BoringReturnOverride_percent"));

  ig::Status build(ig::Block& b) {
    const auto run = cycle_.take(b);
    if (!run) return ig::Status::unchanged;
    const bool is_g86 = run->code == g86_;
    const double feed = cycle_.stroke_feed(b, std::fabs(run->r_level - run->bottom));
    const double dwell = waits(run->code) ? dwell_.seconds(*run) : 0;
    cycle_.report_unused(b, *run, waits(run->code) ? "P" : "");
    const auto start = is_g86 ? spindle_.begin(b, cycle_.motion, cycle_.where(*run), run->code) : ig::Spindle::stop;
    ig::CompoundSteps steps(b, cycle_.motion);

    for (int i = 0; i < run->count; ++i) {
      const CycleHole hole = run->hole(i);
      feed_to_bottom(steps, *run, hole, {feed, dwell});
      if (is_g86) {
        steps.spindle(ig::Spindle::stop);
        steps.rapid_to(hole.at(run->return_level));
        steps.spindle(start);
      } else if (retract_ == Retract::feed_to_final) {
        steps.feed_to(hole.at(run->return_level), feed * return_override_);
      } else {
        steps.feed_to(hole.at(run->r_level), feed * return_override_);
        if (run->returns_to_initial) steps.rapid_to(hole.at(run->return_level));
      }
    }
    cycle_.end(b, *run);
    return ig::Status::changed;
  }

 private:
  bool waits(ig::Symbol code) const { return code == g89_ || (code == g86_ && g86_dwell_ == StopDwell::bottom); }
  /// Where the machine gives no override, or 0, the retract has the feed of the infeed.
  static double override_of(std::optional<double> percent) { return percent && *percent > 0 ? *percent / 100 : 1; }
};

const ig::Register<BoringCycle> boring_cycle_syntax;

}  // namespace
}  // namespace iso
