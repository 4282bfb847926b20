/// CYCLE85: rapid to the safety distance, feed FFR to the depth, wait there, feed RFF back, rapid to the retract plane.
#include "drilling_cycle.hpp"

namespace siemens {
namespace {

struct SiemensReamingCycle {
  static constexpr auto spec = ig::syntax("SiemensReamingCycleSyntax", "CYCLE85 reaming: feed in, feed out.")
                                   .after("SiemensCycleSyntax", "FeedrateSyntax")
                                   .before("ProgramXyzSyntax", "McXyzSyntax", "LinearMotionSyntax");

  DrillingCall cycle_{3, 1};

  ig::Status build(ig::Block& b) {
    const auto run = cycle_.take(b);
    if (!run) return ig::Status::changed;
    const double in = speed(b, *run, "FFR", run->feed);
    const double back = speed(b, *run, "RFF", in);
    const ig::CompoundMotion& motion = cycle_.motion;
    motion.rapid_to(b, run->at(run->start));
    motion.feed_to(b, run->at(run->depth), in);
    if (run->dwell > 0) motion.dwell(b, run->dwell);
    motion.feed_to(b, run->at(run->start), back);
    motion.rapid_to(b, run->at(run->retract));
    cycle_.end(b, *run);
    return ig::Status::changed;
  }

 private:
  double speed(ig::Block& b, const DrillingRun& run, std::string_view parameter, double otherwise) const {
    const auto named = run[parameter];
    const double mmds = named && *named != 0 ? cycle_.feed.mmds(b, named) : otherwise;
    if (!(mmds > 0)) b.report(diag("SIE-0186"), DrillingCall::where(run, parameter), run.cycle->name());
    return mmds;
  }
};

const ig::Register<SiemensReamingCycle> registered;

}  // namespace
}  // namespace siemens
