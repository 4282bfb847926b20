/// G73: drill in pecks of Q and go back a little after each peck, so that the chip breaks.
///
/// Carries out the call that CannedCycleResolveSyntax has resolved. Every step is an item of the motion, even one of
/// length 0.
#include "cycles/peck_cycle_util.hpp"

namespace iso {
namespace {

struct HighSpeedPeckCycle {
  static constexpr auto spec =
      ig::syntax("HighSpeedPeckCycleSyntax", "G73 high-speed peck drilling cycle: a short retract after each peck.")
          .after("CannedCycleResolveSyntax")
          .before("IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");

  CannedCycle cycle_{"G73"};
  PeckCycle pecks_{"HighSpeedPeckRetraction_mm"};
  PeckDwell dwell_;
  enum class LastRetract { by_d, direct };
  ig::Choice<LastRetract> last_retract_{
      "last-retract", "by-d|direct", "by-d",
      "The retract after the last peck: by d and then to the return level, or directly to the return level."};

  ig::Status build(ig::Block& b) {
    const auto run = cycle_.take(b);
    if (!run) return ig::Status::unchanged;
    const auto pecks = pecks_.plan(b, cycle_, *run);
    const double feed = pecks ? cycle_.stroke_feed(b, std::fabs(run->r_level - run->bottom)) : 0;
    const bool returns = pecks && pecks->full_return > 0;
    std::string_view used = pecks_.used(*run, returns ? "QKP" : "QP", "IJKP");
    if (!dwell_.is_used()) used.remove_suffix(1);
    cycle_.report_unused(b, *run, used);
    ig::CompoundSteps steps(b, cycle_.motion);

    for (int i = 0; i < run->count; ++i) {
      const CycleHole hole = run->hole(i);
      steps.rapid_to(hole.at(hole.approach_level));
      if (pecks) {
        steps.rapid_to(hole.at(run->r_level));
        double out_at = run->r_level;  // where the chips came out last
        for (int k = 1; k <= pecks->count; ++k) {
          steps.feed_to(hole.at(pecks->level(k)), feed);
          dwell_.dwell(steps, *run, pecks->is_last(k));
          if (returns && !pecks->is_last(k) && std::fabs(pecks->level(k) - out_at) >= pecks->full_return - 1e-7) {
            steps.rapid_to(hole.at(pecks->clear_level));
            out_at = pecks->level(k);
          }
          if (!pecks->is_last(k) || last_retract_ == LastRetract::by_d) steps.rapid_to(hole.at(pecks->clear_of(k)));
        }
      }
      steps.rapid_to(hole.at(run->return_level));
    }
    cycle_.end(b, *run);
    return ig::Status::changed;
  }
};

const ig::Register<HighSpeedPeckCycle> high_speed_peck_cycle_syntax;

}  // namespace
}  // namespace iso
