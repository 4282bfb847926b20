/// CYCLE86: bore to the depth, stop the spindle at its angle, move the tip off the wall, and retract by rapid. CYCLE87
/// and CYCLE88: bore to the depth, stop spindle and program, and retract by rapid when the operator goes on.
#include <isogloss/cnc/cycle_spindle.hpp>

#include "cycles/drilling_cycle.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensBoringCycle {
  static constexpr auto spec =
      ig::syntax("SiemensBoringCycleSyntax", "CYCLE86/CYCLE87/CYCLE88 boring: the spindle stops before the retract.")
          .after("SiemensCycleSyntax", "SiemensPatternCallSyntax", "SiemensDrillingCycleSyntax",
                 "SiemensDeepHoleCycleSyntax", "SiemensReamingCycleSyntax", "FeedrateSyntax", "SpindleSpeedSyntax",
                 "SiemensSpindlePositionSyntax")
          .before("ProgramXyzSyntax", "McXyzSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_NOTE, "SIE-0196",
                     "{0}: M0 stops the program at the bottom of the hole, but is listed after the retract"),
  };

  DrillingCall cycle_{"CYCLE86", "CYCLE87", "CYCLE88"};
  CycleSpindle spindle_;
  ig::Out<ig::Symbol> program_stop_{"ProgramStop.Term"};
  ig::Name m00_{"M00"};

  ig::Status build(ig::Block& b) {
    auto run = cycle_.take(b);
    if (!run) return ig::Status::changed;
    const auto turns = direction(b, *run);
    if (!turns) {
      cycle_.stay(b, *run);
      return ig::Status::changed;
    }
    spindle_.begin(b, cycle_.motion, ig::Spindle::stop);
    if (run->cycle->name() == "CYCLE86") {
      lift(b, *run, *turns);
      return ig::Status::changed;
    }
    cycle_.drill(b, *run, [&](const DrillingRun& hole) {
      bore(b, hole, *turns);
      cycle_.motion.spindle(b, ig::Spindle::stop);
      cycle_.motion.rapid_to(b, hole.at(hole.retract));
    });
    b.report(ig::diag("SIE-0196"), DrillingCall::where(*run), run->cycle->name());
    b.set(program_stop_, m00_);
    return ig::Status::changed;
  }

 private:
  /// The direction of SDIR 3 or 4; without SDIR the present direction of the spindle.
  std::optional<ig::Spindle> direction(ig::Block& b, const DrillingRun& run) const {
    const double sdir = run["SDIR"].value_or(0);
    if (sdir == 3) return ig::Spindle::cw;
    if (sdir == 4) return ig::Spindle::ccw;
    const auto now = spindle_.direction(b);
    for (const ig::Spindle turning : {ig::Spindle::cw, ig::Spindle::ccw})
      if (sdir == 0 && now && *now == spindle_.name(turning)) return turning;
    b.report(ig::diag("SIE-0197"), DrillingCall::where(run, "SDIR"), run.cycle->name(), std::string_view("SDIR"), sdir);
    return std::nullopt;
  }

  void bore(ig::Block& b, const DrillingRun& hole, ig::Spindle turns) const {
    const ig::CompoundMotion& motion = cycle_.motion;
    motion.rapid_to(b, hole.at(hole.start));
    motion.spindle(b, turns);
    motion.feed_to(b, hole.at(hole.depth), hole.feed);
    if (hole.dwell > 0) motion.dwell(b, hole.dwell);
  }

  void lift(ig::Block& b, DrillingRun& run, ig::Spindle turns) const {
    const ig::CompoundMotion& motion = cycle_.motion;
    const bool lifts = run.mode("GMODE", 0) != 1;
    const double along = lifts ? run["RPAP"].value_or(0) : 0;
    ig::Vec3 aside;
    aside[run.plane.first] = lifts ? run["RPA"].value_or(0) : 0;
    aside[run.plane.second] = lifts ? run["RPO"].value_or(0) : 0;
    cycle_.drill(b, run, [&](const DrillingRun& hole) {
      bore(b, hole, turns);
      motion.orient(b, angle(run["POSS"].value_or(0)));
      if (lifts) motion.rapid_to(b, hole.at(hole.depth + along) + aside);
      if (lifts) motion.rapid_to(b, hole.at(hole.start) + aside);
      motion.rapid_to(b, hole.at(hole.retract));
    });
  }
  static double angle(double degrees) {
    const double turn = std::fmod(degrees, 360);
    return turn < 0 ? turn + 360 : turn;
  }
};

const ig::Register<SiemensBoringCycle> siemens_boring_cycle_syntax;

}  // namespace
}  // namespace siemens
