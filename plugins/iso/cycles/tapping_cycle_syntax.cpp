/// G84 and G74: feed to the bottom with the turning tap, reverse the spindle, feed out, and turn as before. In rigid
/// tapping (M29, or by a parameter) axis and spindle are coupled, the spindle is at rest before and after the hole, and
/// Q divides the depth into pecks.
///
/// Carries out the call that CannedCycleResolveSyntax has resolved. Every step is an item of the motion, even one of
/// length 0.
#include <isogloss/cnc/arc.hpp>
#include <isogloss/cnc/restarted_spindle.hpp>
#include <isogloss/sdk.hpp>

#include "cycles/peck_tapping.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct TappingCycle {
  static constexpr auto spec = ig::syntax("TappingCycleSyntax", "G84/G74 tapping cycle, floating or rigid.")
                                   .after("CannedCycleResolveSyntax", "SpindleSpeedSyntax", "RigidTappingModeSyntax")
                                   .before("IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0347", "{0}: the spindle direction is {1}, but the tap must enter with {2}"),
      ig::diagnostic(IG_WARNING, "ISO-0348", "{0}: Q is the depth of cut in rigid tapping only and is ignored here"),
      ig::diagnostic(IG_ERROR, "ISO-0349", "rigid tapping without a spindle speed: program S with M29"),
      ig::diagnostic(IG_ERROR, "ISO-0351",
                     "{0}: Q{1} gives more than {2} cuts, so the last cut goes straight to the bottom"),
      ig::diagnostic(IG_WARNING, "ISO-0353", "{0}: the retract of {1} mm is longer than the depth of cut Q{2}"),
      ig::diagnostic(IG_WARNING, "ISO-0374", "{0} J{1}: J must be above 0 and at most 20, so it is ignored"),
  };

  enum class Retract { feed_to_final, feed_to_r };
  enum class Dwell { none, bottom, bottom_and_r };
  enum class SpindleStop { none, before_reversal, parameter };
  enum class Rigid { by_code, always, parameter };
  enum class PeckRetract { by_d, to_r, parameter };
  enum class PeckDwell { last, every };
  enum class JWord { none, retract_speed };

  CannedCycle cycle_{"G84", "G74"};
  CycleDwell dwell_;
  CycleSpindle spindle_;
  ig::Choice<Retract> retract_{"retract", "feed-to-final|feed-to-r", "feed-to-final",
                               "How far the tap retracts by feed."};
  ig::Choice<Dwell> dwell_at_{"dwell", "none|bottom|bottom-and-r", "none", "Where P waits."};
  ig::Choice<SpindleStop> stop_{"spindle-stop", "none|before-reversal|parameter", "none",
                                "Floating: whether the spindle is stopped before it is reversed."};
  ig::Choice<Rigid> rigid_by_{"rigid", "by-code|always|parameter", "by-code",
                              "Rigid only after M29, always, or by the machine's parameter."};
  ig::Choice<PeckRetract> peck_retract_{"peck-retract", "by-d|to-r|parameter", "by-d",
                                        "How far the tap retracts between the cuts of rigid tapping."};
  ig::Choice<PeckDwell> peck_dwell_{"peck-dwell", "last|every", "last", "After which cuts the tap dwells for P."};
  ig::Choice<JWord> j_word_{"j-word", "none|retract-speed", "none",
                            "Whether J says how many times as fast a rigid tap leaves the hole."};
  ig::IntegerOption max_pecks_{"max-pecks", "10000", {1, most_pecks}, "The largest number of cuts in one hole."};
  ig::Config config_{"isogloss.canned-cycle/1", ig::Need::optional, "The machine's tapping parameters."};

  ig::In<ig::Symbol> rigid_mode_{"RigidTapping.Term"};
  ig::In<double> kept_q_{"CannedCycle.Params.Q"};
  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::Signal q_of_another_use_{"CannedCycle.~QOfAnotherUse", ig::read};
  ig::Name g84_{"G84"};

  ig::Status build(ig::Block& b) {
    auto run = cycle_.take(b);
    if (!run) return ig::Status::unchanged;
    const Tap tap = tap_of(b, *run);
    std::string_view used = "PQJ";
    if (j_word_ == JWord::none || !tap.rigid) used.remove_suffix(1);
    if (dwell_at_ == Dwell::none) used.remove_prefix(1);
    cycle_.report_unused(b, *run, used);
    limit_steps(b, *run, tap.steps());
    spindle_.begin(b, cycle_.motion, tap.rigid ? ig::Spindle::stop : tap.in);
    for (int i = 0; i < run->count; ++i) {
      const CycleHole hole = run->hole(i);
      cycle_.motion.rapid_to(b, hole.at(hole.approach_level));
      cycle_.motion.rapid_to(b, hole.at(run->r_level));
      thread(b, hole, tap);
    }
    cycle_.end(b, *run);
    return ig::Status::changed;
  }

 private:
  static constexpr double most_speed = 20;  // the largest extraction override of a Fanuc: 2000 %

  /// What is the same for all holes of the block.
  struct Tap {
    ig::Spindle in, out;
    bool rigid = false, stops = false, returns_by_rapid = false;
    double feed = 0, feed_out = 0;                           // mm/s
    double bottom_dwell = 0, peck_dwell = 0, out_dwell = 0;  // s
    double r_level = 0, out_level = 0, return_level = 0;
    PeckTapping pecks;
    bool to_r = false;

    std::int64_t steps() const { return 11 + 7 * std::int64_t{pecks.count - 1}; }
  };

  void thread(ig::Block& b, const CycleHole& hole, const Tap& tap) const {
    const ig::CompoundMotion& motion = cycle_.motion;
    if (tap.rigid) motion.spindle(b, tap.in);
    for (int k = 1; k < tap.pecks.count; ++k) {
      motion.feed_to(b, hole.at(tap.pecks.depth(k)), tap.feed);
      motion.spindle(b, ig::Spindle::stop);
      if (tap.peck_dwell > 0) motion.dwell(b, tap.peck_dwell);
      motion.spindle(b, tap.out);
      motion.feed_to(b, hole.at(tap.to_r ? tap.r_level : tap.pecks.clearance(k)), tap.feed_out);
      motion.spindle(b, tap.in);
      if (tap.to_r) motion.feed_to(b, hole.at(tap.pecks.clearance(k)), tap.feed);
    }
    motion.feed_to(b, hole.at(tap.pecks.bottom), tap.feed);
    if (tap.stops) motion.spindle(b, ig::Spindle::stop);
    if (tap.bottom_dwell > 0) motion.dwell(b, tap.bottom_dwell);
    motion.spindle(b, tap.out);
    motion.feed_to(b, hole.at(tap.out_level), tap.feed_out);
    if (tap.stops) motion.spindle(b, ig::Spindle::stop);
    if (tap.out_dwell > 0) motion.dwell(b, tap.out_dwell);
    if (!tap.rigid) motion.spindle(b, tap.in);
    if (tap.returns_by_rapid) motion.rapid_to(b, hole.at(tap.return_level));
  }

  Tap tap_of(ig::Block& b, const CycleRun& run) const {
    Tap tap;
    const bool right_hand = run.code == g84_;
    tap.in = right_hand ? ig::Spindle::cw : ig::Spindle::ccw;
    tap.out = right_hand ? ig::Spindle::ccw : ig::Spindle::cw;
    tap.rigid = is_rigid(b);
    tap.stops = tap.rigid || stops_before_reversal();
    tap.r_level = run.r_level;
    tap.return_level = run.return_level;
    tap.out_level = retract_ == Retract::feed_to_r ? run.r_level : run.return_level;
    tap.returns_by_rapid = retract_ == Retract::feed_to_r && run.returns_to_initial;
    tap.feed = cycle_.stroke_feed(b, std::fabs(run.r_level - run.bottom));
    tap.feed_out = tap.rigid ? tap.feed * retract_speed(b, run) : tap.feed;
    const double dwell = dwell_.seconds(run);
    if (dwell_at_ != Dwell::none) tap.bottom_dwell = dwell;
    if (dwell_at_ == Dwell::bottom_and_r) tap.out_dwell = dwell;
    if (peck_dwell_ == PeckDwell::every) tap.peck_dwell = tap.bottom_dwell;
    tap.pecks = pecks_of(b, run, tap.rigid);
    tap.to_r = peck_retract_ == PeckRetract::parameter ? parameter("PeckTappingToR", 0) != 0
                                                       : peck_retract_ == PeckRetract::to_r;
    check_spindle(b, run, tap);
    return tap;
  }

  bool is_rigid(const ig::Block& b) const {
    if (b.has(rigid_mode_) || rigid_by_ == Rigid::always) return true;
    return rigid_by_ == Rigid::parameter && parameter("RigidTapping", 0) != 0;
  }
  bool stops_before_reversal() const {
    return stop_ == SpindleStop::parameter ? parameter("TappingSpindleStop", 1) != 0
                                           : stop_ == SpindleStop::before_reversal;
  }
  /// The speed of the retract as a factor of the speed of the infeed.
  double retract_speed(ig::Block& b, const CycleRun& run) const {
    if (j_word_ == JWord::retract_speed && run.words.has(CycleWords::J)) {
      const double j = run.words.get_or(CycleWords::J, 0);
      if (j > 0 && j <= most_speed) return j;
      if (j != 0) b.report(ig::diag("ISO-0374"), cycle_.where(run, CycleWords::J), b.text(run.code), j);
    }
    const double percent = parameter("TappingExtractionOverride_percent", 100);
    return percent > 0 ? percent / 100 : 1;
  }
  double parameter(std::string_view name, double fallback) const { return config_.number(name).value_or(fallback); }

  /// With a floating holder one cut; in rigid tapping cuts of Q, whose sign has no meaning.
  PeckTapping pecks_of(ig::Block& b, const CycleRun& run, bool rigid) const {
    const double q = run.words.get_or(CycleWords::Q, 0);
    if (!rigid && q != 0 && !is_kept(b)) b.report(ig::diag("ISO-0348"), ig::Where::block(), b.text(run.code));
    if (!rigid || q == 0) return {run.r_level, run.bottom};
    if (q < 0) b.report(ig::diag("ISO-0343"), ig::Where::block(), b.text(run.code), q);
    if (b.is_raised(q_of_another_use_))
      b.report(ig::diag("ISO-0344"), ig::Where::block(), b.text(run.code), q, std::string_view("depth of cut"));
    const auto most = static_cast<int>(static_cast<std::int64_t>(max_pecks_));
    const PeckTapping pecks(run.r_level, run.bottom, q, parameter("PeckTappingRetraction_mm", 1), most);
    if (pecks.is_cut_short)
      b.report(ig::diag("ISO-0351"), ig::Where::block(), b.text(run.code), q, static_cast<double>(most));
    if (pecks.count > 1 && pecks.retract > pecks.step + same_point_mm)
      b.report(ig::diag("ISO-0353"), ig::Where::block(), b.text(run.code), pecks.retract, pecks.step);
    return pecks;
  }
  bool is_kept(const ig::Block& b) const { return b.has(kept_q_) && !b.is_fresh(kept_q_); }

  void check_spindle(ig::Block& b, const CycleRun& run, const Tap& tap) const {
    if (tap.rigid) {
      if (tap.feed > 0 && b.get_or(speed_, 0.0) <= 0) b.report(ig::diag("ISO-0349"), ig::Where::block());
      return;
    }
    const auto now = spindle_.direction(b);
    if (now && *now != spindle_.name(tap.in))
      b.report(ig::diag("ISO-0347"), ig::Where::block(), b.text(run.code), b.text(*now), b.text(spindle_.name(tap.in)));
  }
};

const ig::Register<TappingCycle> tapping_cycle_syntax;

}  // namespace
}  // namespace iso
