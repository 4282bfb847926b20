/// G87: the bar goes down through an existing bore, off its centre, and bores upward, towards the spindle, into the
/// back side of the workpiece.
///
/// Carries out the call that CannedCycleResolveSyntax has resolved. Every step is an item of the motion, even one of
/// length 0.
#include <string>

#include <isogloss/cnc/restarted_spindle.hpp>

#include "cycles/tool_shift.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct BackBoring {
  static constexpr auto spec =
      ig::syntax("BackBoringSyntax", "G87 back boring: enters the bore off centre, then cuts upward.")
          .after("CannedCycleResolveSyntax", "ManualBoringCycleSyntax", "SpindleSpeedSyntax")
          .before("IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0345",
                     "G87 under G99: back boring always returns to the initial level, so program G98"),
      ig::diagnostic(IG_ERROR, "ISO-0346", "G87: {0} at {1} is not below {2} at {3}, so the cut does not run upward"),
  };

  enum class RLevel { top, bottom };
  enum class Positioning { shifted, centred };
  enum class Dwell { none, end_of_cut };

  enum class Code { g87, g77 };

  ig::Choice<Code> code_{"code", "G87|G77", "G87", "The code of the cycle."};
  CannedCycle g87_{"G87"}, g77_{"G77"};
  const CannedCycle& cycle_ = code_ == Code::g87 ? g87_ : g77_;
  CycleDwell dwell_;
  RestartedSpindle spindle_;
  ToolShift shift_;
  ig::Choice<RLevel> r_is_{"r-is", "top|bottom", "top", "Which end of the cut R means; Z means the other end."};
  ig::Choice<Positioning> positioning_{"positioning", "shifted|centred", "shifted",
                                       "Where the tool shifts: on its way to the bore, or at the bore."};
  ig::Choice<Dwell> dwell_at_{"dwell", "none|end-of-cut", "none", "Where P waits."};
  CycleReturnLevel return_level_;

  ig::Status build(ig::Block& b) {
    auto run = cycle_.take(b);
    if (!run) return ig::Status::unchanged;
    limit_steps(b, *run, 13);
    const double low = r_is_ == RLevel::top ? run->bottom : run->r_level;
    const double high = r_is_ == RLevel::top ? run->r_level : run->bottom;
    check_levels(b, *run, low, high);
    const double feed = cycle_.stroke_feed(b, std::fabs(high - low));
    const double dwell = dwell_at_ == Dwell::end_of_cut ? dwell_.seconds(*run) : 0;
    const ToolShift::Shift shift = shift_.of(b, *run);
    const std::string_view dwells = dwell_at_ == Dwell::none ? "" : "P";
    cycle_.report_unused(b, *run, std::string(dwells).append(shift_.used_words(*run)));
    const ig::CompoundMotion& motion = cycle_.motion;
    const auto start = spindle_.begin(b, motion, cycle_.where(*run), run->code);

    for (int i = 0; i < run->count; ++i) {
      const CycleHole bore = run->hole(i);
      const CycleHole aside = shifted(bore, shift.vector);
      if (positioning_ == Positioning::centred) {
        motion.rapid_to(b, bore.at(bore.approach_level));
        motion.orient(b, shift_.angle());
        ToolShift::move_aside(b, motion, shift, aside.at(bore.approach_level), feed);
      } else {
        motion.orient(b, shift_.angle());
        motion.rapid_to(b, aside.at(bore.approach_level));
      }
      motion.rapid_to(b, aside.at(low));
      ToolShift::move_aside(b, motion, shift, bore.at(low), feed);
      motion.spindle(b, start);
      motion.feed_to(b, bore.at(high), feed);
      if (dwell > 0) motion.dwell(b, dwell);
      shift_.retract(b, motion, bore, shift, high, run->return_level, feed, start);
    }
    cycle_.end(b, *run);
    return ig::Status::changed;
  }

 private:
  /// R is below the workpiece, where the bar must not stay: the tool returns to the initial level.
  void check_levels(ig::Block& b, CycleRun& run, double low, double high) const {
    if (r_is_ == RLevel::bottom && !run.returns_to_initial) {
      b.report(ig::diag("ISO-0345"), ig::Where::block());
      run.return_level = return_level_(b, run.plane.tool, run.start[run.plane.tool]);
    }
    if (low < high) return;
    const char bottom_word = "XYZ"[run.plane.tool];
    const std::string_view z(&bottom_word, 1);
    const bool r_is_top = r_is_ == RLevel::top;
    b.report(ig::diag("ISO-0346"), ig::Where::block(), r_is_top ? z : std::string_view("R"), low,
             r_is_top ? std::string_view("R") : z, high);
  }
};

const ig::Register<BackBoring> back_boring_syntax;

}  // namespace
}  // namespace iso
