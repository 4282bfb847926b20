/// CYCLE85 and CYCLE89: rapid to the safety distance, feed to the depth, dwell there, retract by feed, rapid to the
/// retract plane. CYCLE85 has feeds of its own, FFR and RFF.
#include "cycles/drilling_cycle.hpp"

namespace siemens {
namespace {

struct SiemensReamingCycle {
  static constexpr auto spec =
      ig::syntax("SiemensReamingCycleSyntax", "CYCLE85/CYCLE89 reaming and boring: feed in, feed out.")
          .after("SiemensCycleSyntax", "SiemensPatternCallSyntax", "SiemensDrillingCycleSyntax",
                 "SiemensDeepHoleCycleSyntax", "FeedrateSyntax")
          .before("ProgramXyzSyntax", "McXyzSyntax", "LinearMotionSyntax");

  DrillingCall cycle_{"CYCLE85", "CYCLE89"};

  ig::Status build(ig::Block& b) {
    auto run = cycle_.take(b);
    if (!run) return ig::Status::changed;
    const bool has_feeds = run->cycle->name() == "CYCLE85";
    const double in = has_feeds ? speed(b, *run, "FFR", run->feed) : run->feed;
    const double back = has_feeds ? speed(b, *run, "RFF", in) : run->feed;
    const ig::CompoundMotion& motion = cycle_.motion;
    cycle_.drill(b, *run, [&](const DrillingRun& hole) {
      motion.rapid_to(b, hole.at(hole.start));
      motion.feed_to(b, hole.at(hole.depth), in);
      if (hole.dwell > 0) motion.dwell(b, hole.dwell);
      motion.feed_to(b, hole.at(hole.start), back);
      motion.rapid_to(b, hole.at(hole.retract));
    });
    return ig::Status::changed;
  }

 private:
  double speed(ig::Block& b, const DrillingRun& run, std::string_view parameter, double otherwise) const {
    const auto named = run[parameter];
    const double mmds = named && *named != 0 ? cycle_.feed.mmds(b, named) : otherwise;
    if (!(mmds > 0)) b.report(ig::diag("SIE-0186"), DrillingCall::where(run, parameter), run.cycle->name());
    return mmds;
  }
};

const ig::Register<SiemensReamingCycle> siemens_reaming_cycle_syntax;

}  // namespace
}  // namespace siemens
