/// CYCLE84: rigid tapping; spindle and axis are coupled, in one cut or in pecks. CYCLE840: tapping with a floating
/// holder. The feed follows from the pitch and the spindle speed.
#include <isogloss/cnc/cycle_spindle.hpp>

#include "cycles/drilling_cycle.hpp"
#include "motion/thread_pitch.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensTappingCycle {
  static constexpr auto spec =
      ig::syntax("SiemensTappingCycleSyntax", "CYCLE84 rigid tapping, CYCLE840 tapping with a floating holder.")
          .after("SiemensCycleSyntax", "SiemensPatternCallSyntax", "SiemensDrillingCycleSyntax",
                 "SiemensDeepHoleCycleSyntax", "SiemensReamingCycleSyntax", "SiemensBoringCycleSyntax",
                 "FeedrateSyntax", "SpindleSpeedSyntax", "SiemensSpindlePositionSyntax")
          .before("ProgramXyzSyntax", "McXyzSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0198", "{0} is not executed: MPIT={1} and PIT={2} give no pitch (alarm 61001)"),
      ig::diagnostic(IG_ERROR, "SIE-0199",
                     "{0} is not executed, because the spindle speed is not known: program S before it"),
  };

  DrillingCall cycle_{"CYCLE84", "CYCLE840"};
  CycleSpindle spindle_;
  ig::NumberOption chip_break_{"chip-break", "1", {0, 1000}, "mm", "The retract of chip breaking without _VRT."};
  ig::In<ig::Symbol> unit_{"Unit.System"};
  ig::Name inch_{"Inch"};

  ig::Status build(ig::Block& b) {
    auto run = cycle_.take(b);
    if (!run) return ig::Status::changed;
    const auto tap = run->cycle->name() == "CYCLE84" ? rigid(b, *run) : floating(b, *run);
    if (!tap) {
      cycle_.stay(b, *run);
      return ig::Status::changed;
    }
    spindle_.begin(b, cycle_.motion, tap->last);
    cycle_.drill(b, *run, [&](const DrillingRun& hole) { thread(b, hole, *tap); });
    return ig::Status::changed;
  }

 private:
  static constexpr double most_cuts = 10'000;
  static constexpr double rounding_mm = 1e-9;
  enum class Cuts { one, chip_breaking, chip_removal };

  struct Tap {
    ig::Spindle in, out, last;
    double feed_in = 0, feed_out = 0;  // mm/s
    std::optional<double> angle;       // of the oriented stop before the cut
    Cuts cuts = Cuts::one;
    double cut = 0, back = 0;  // mm
    double dwell = 0;
  };

  void thread(ig::Block& b, const DrillingRun& hole, const Tap& tap) const {
    const ig::CompoundMotion& motion = cycle_.motion;
    const double total = std::fabs(hole.reference - hole.depth);
    motion.rapid_to(b, hole.at(hole.start));
    if (tap.angle) motion.orient(b, *tap.angle);
    motion.spindle(b, tap.in);
    for (int k = 1; tap.cuts != Cuts::one && k * tap.cut < total - rounding_mm; ++k) {
      const double depth = hole.reference - hole.out * k * tap.cut;
      motion.feed_to(b, hole.at(depth), tap.feed_in);
      motion.spindle(b, tap.out);
      const double up = tap.cuts == Cuts::chip_removal ? hole.start : depth + hole.out * tap.back;
      motion.feed_to(b, hole.at(up), tap.feed_out);
      motion.spindle(b, tap.in);
    }
    motion.feed_to(b, hole.at(hole.depth), tap.feed_in);
    if (tap.dwell > 0) motion.dwell(b, tap.dwell);
    motion.spindle(b, tap.out);
    motion.feed_to(b, hole.at(hole.start), tap.feed_out);
    if (tap.angle) motion.spindle(b, ig::Spindle::stop);
    motion.rapid_to(b, hole.at(hole.retract));
    motion.spindle(b, tap.last);
  }

  std::optional<double> pitch(ig::Block& b, const DrillingRun& run) const {
    const double mpit = run["MPIT"].value_or(0), pit = run["PIT"].value_or(0);
    const auto p = thread_pitch(mpit, pit, run["PITA"].value_or(0), b.is(unit_, inch_));
    if (p && std::fabs(*p) < 1e6) return p;
    b.report(ig::diag("SIE-0198"), DrillingCall::where(run), run.cycle->name(), mpit, pit);
    return std::nullopt;
  }
  bool has_speed(ig::Block& b, const DrillingRun& run, double rpm) const {
    if (rpm > 0) return true;
    b.report(ig::diag("SIE-0199"), DrillingCall::where(run), run.cycle->name());
    return false;
  }
  /// 3, 4 or 5: the direction of the spindle after the cycle; the direction before it where no parameter gives one.
  std::optional<ig::Spindle> turning(ig::Block& b, const DrillingRun& run, std::string_view parameter) const {
    const double n = run[parameter].value_or(0);
    if (n == 3) return ig::Spindle::cw;
    if (n == 4) return ig::Spindle::ccw;
    if (n == 5) return ig::Spindle::stop;
    if (n == 0) return present(b);
    b.report(ig::diag("SIE-0197"), DrillingCall::where(run, parameter), run.cycle->name(), parameter, n);
    return std::nullopt;
  }
  ig::Spindle present(const ig::Block& b) const {
    const auto now = spindle_.direction(b);
    for (const ig::Spindle turns : {ig::Spindle::cw, ig::Spindle::ccw})
      if (now && *now == spindle_.name(turns)) return turns;
    return ig::Spindle::stop;
  }
  static ig::Spindle opposite(ig::Spindle turns) {
    return turns == ig::Spindle::cw ? ig::Spindle::ccw : ig::Spindle::cw;
  }

  std::optional<Tap> rigid(ig::Block& b, const DrillingRun& run) const {
    const auto p = pitch(b, run);
    const auto last = turning(b, run, "SDAC");
    if (!p || !last) return std::nullopt;
    const double sst = run["SST"].value_or(0), sst1 = run["SST1"].value_or(0);
    const double speed = sst != 0 ? std::fabs(sst) : cycle_.feed.rpm(b);
    if (!has_speed(b, run, speed)) return std::nullopt;
    const double variant = run["VARI"].value_or(0);
    if (variant != 0 && variant != 1 && variant != 2) {
      b.report(ig::diag("SIE-0191"), DrillingCall::where(run, "VARI"), run.cycle->name(), variant);
      return std::nullopt;
    }
    const double hand = run.mode("AMODE", 3);
    const bool is_left = hand == 0 ? *p < 0 : hand == 2;
    Tap tap;
    tap.in = is_left ? ig::Spindle::ccw : ig::Spindle::cw;
    tap.out = opposite(tap.in);
    tap.last = *last;
    tap.feed_in = speed * std::fabs(*p) / 60;
    tap.feed_out = (sst1 != 0 ? std::fabs(sst1) : speed) * std::fabs(*p) / 60;
    const double turn = std::fmod(run["POSS"].value_or(0), 360);
    tap.angle = turn < 0 ? turn + 360 : turn;
    tap.dwell = run.dwell;
    const double total = std::fabs(run.reference - run.depth);
    tap.cuts = variant == 1 ? Cuts::chip_breaking : variant == 2 ? Cuts::chip_removal : Cuts::one;
    tap.cut = std::fabs(run["DAM"].value_or(0));
    if (tap.cut == 0) tap.cuts = Cuts::one;
    if (tap.cuts != Cuts::one && total / tap.cut > most_cuts) {
      b.report(ig::diag("SIE-0195"), DrillingCall::where(run, "DAM"), run.cycle->name(), most_cuts);
      return std::nullopt;
    }
    const double back = run["VRT"].value_or(0);
    tap.back = back > 0 ? back : double{chip_break_};
    return tap;
  }

  std::optional<Tap> floating(ig::Block& b, const DrillingRun& run) const {
    const double enc = run["ENC"].value_or(0);
    if (enc != 0 && enc != 1 && enc != 11 && enc != 20) {
      b.report(ig::diag("SIE-0191"), DrillingCall::where(run, "ENC"), run.cycle->name(), enc);
      return std::nullopt;
    }
    const auto last = turning(b, run, "SDAC");
    const auto out = turning(b, run, "SDR");
    const ig::Spindle now = present(b);
    if (!last || !out) return std::nullopt;
    const bool reverses = run["SDR"].value_or(0) == 0;
    if ((reverses && now == ig::Spindle::stop) || *out == ig::Spindle::stop) {
      b.report(ig::diag("SIE-0197"), DrillingCall::where(run, "SDR"), run.cycle->name(), std::string_view("SDR"),
               run["SDR"].value_or(0));
      return std::nullopt;
    }
    Tap tap;
    tap.out = reverses ? opposite(now) : *out;
    tap.in = opposite(tap.out);
    tap.last = *last;
    tap.feed_in = run.feed;  // ENC 1: F is the speed times the pitch
    if (enc != 1) {
      const auto p = pitch(b, run);
      if (!p || !has_speed(b, run, cycle_.feed.rpm(b))) return std::nullopt;
      tap.feed_in = cycle_.feed.rpm(b) * std::fabs(*p) / 60;
    } else if (run.feed <= 0) {
      b.report(ig::diag("SIE-0186"), DrillingCall::where(run), run.cycle->name());
    }
    tap.feed_out = tap.feed_in;
    if (enc != 0) tap.dwell = run.dwell;
    return tap;
  }
};

const ig::Register<SiemensTappingCycle> siemens_tapping_cycle_syntax;

}  // namespace
}  // namespace siemens
