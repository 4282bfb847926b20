/// CYCLE83: drilling in strokes, with a short retract that breaks the chip (VARI 0), or a retract to the safety
/// distance after each stroke (VARI 1).
#include "cycles/drilling_cycle.hpp"

namespace siemens {
namespace {

struct SiemensDeepHoleCycle {
  static constexpr auto spec =
      ig::syntax("SiemensDeepHoleCycleSyntax", "CYCLE83 deep hole drilling in strokes.")
          .after("SiemensCycleSyntax", "SiemensPatternCallSyntax", "SiemensDrillingCycleSyntax", "FeedrateSyntax")
          .before("ProgramXyzSyntax", "McXyzSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0193",
                     "{0} is not executed: the first depth {1} mm does not lie within the depth {2} mm (alarm 61107)"),
      ig::diagnostic(IG_ERROR, "SIE-0194",
                     "{0} is not executed: the factor of the first feed is {1}, but must be {2} to {3}"),
  };

  DrillingCall cycle_{"CYCLE83"};
  ig::NumberOption chip_break_{"chip-break", "1", {0, 1000}, "mm", "The retract of VARI 0 if _VRT does not give it."};
  std::vector<double> depths_;  // of the strokes, below the reference plane; a member, to keep its memory

  ig::Status build(ig::Block& b) {
    auto run = cycle_.take(b);
    if (!run) return ig::Status::changed;
    if (plan(b, *run)) {
      const Waits waits{
          cycle_.seconds(b, *run, (*run)["DTS"], run->dwell_unit(2)),
          (*run)["DTD"].value_or(0) != 0 ? cycle_.seconds(b, *run, (*run)["DTD"], run->dwell_unit(3)) : run->dwell};
      cycle_.drill(b, *run, [&](const DrillingRun& hole) { drill(b, hole, waits); });
    } else {
      cycle_.stay(b, *run);
    }
    return ig::Status::changed;
  }

 private:
  static constexpr std::size_t most_strokes = 10'000;
  static constexpr double rounding_mm = 1e-9;

  struct Waits {
    double at_start, at_end;  // s
  };

  void drill(ig::Block& b, const DrillingRun& run, const Waits& waits) const {
    const ig::CompoundMotion& motion = cycle_.motion;
    const double total = std::fabs(run.reference - run.depth);
    const bool clears_chips = run["VARI"].value_or(0) == 1;
    const double own = run.mode("AMODE", limit_digit) == 1 ? 0 : run["DIS1"].value_or(0);
    const double back = run["VRT"].value_or(0);
    const double ahead = own > 0 ? own : total <= 30 ? 0.6 : std::fmin(total / 50, 7);
    const double break_way = back > 0 ? back : double{chip_break_};
    const auto level = [&](double depth) { return run.at(run.reference - run.out * depth); };

    motion.rapid_to(b, run.at(run.start));
    for (std::size_t k = 0; k < depths_.size(); ++k) {
      if (k > 0 && clears_chips) {
        motion.rapid_to(b, run.at(run.start));
        if (waits.at_start > 0) motion.dwell(b, waits.at_start);
        motion.rapid_to(b, level(depths_[k - 1] - ahead));
      } else if (k > 0) {
        motion.feed_to(b, level(depths_[k - 1] - break_way), run.feed);
      }
      motion.feed_to(b, level(depths_[k]), k == 0 ? run.feed * factor(run) : run.feed);
      const double wait = k + 1 == depths_.size() ? waits.at_end : run.dwell;
      if (wait > 0) motion.dwell(b, wait);
    }
    motion.rapid_to(b, run.at(run.retract));
  }

  // Digits of AMODE, counted from the right.
  static constexpr int first_depth_digit = 4, degression_digit = 5, limit_digit = 6, feed_digit = 7;

  static bool is_percentage(const DrillingRun& run) { return run.mode("AMODE", feed_digit) == 1; }

  static double factor(const DrillingRun& run) {
    const double f = run["FRF"].value_or(0);
    return f == 0 ? 1 : is_percentage(run) ? f / 100 : f;
  }

  /// Computes the strokes. False, with a diagnostic, where the control refuses the call.
  bool plan(ig::Block& b, const DrillingRun& run) {
    const std::string_view name = run.cycle->name();
    const double total = std::fabs(run.reference - run.depth);
    double first = total;
    const auto relative = run["FDPR"], absolute = run["FDEP"];
    if (relative && *relative != 0 && (!absolute || run.mode("AMODE", first_depth_digit) != 2))
      first = std::fabs(*relative);
    else if (absolute)
      first = run.out * (run.reference - *absolute);
    if (!(first > 0) || first > total + rounding_mm) {
      b.report(ig::diag("SIE-0193"), DrillingCall::where(run, "FDEP"), name, first, total);
      return false;
    }
    if (const double f = factor(run), least = is_percentage(run) ? 1e-5 : 0.001, most = is_percentage(run) ? 10 : 1;
        !(f >= least && f <= most)) {
      b.report(ig::diag("SIE-0194"), DrillingCall::where(run, "FRF"), name, f, least, most);
      return false;
    }
    if (run["AXN"].value_or(0) != 0 && run["AXN"].value_or(0) != 3) {
      b.report(ig::diag("SIE-0191"), DrillingCall::where(run, "AXN"), name, *run["AXN"]);
      return false;
    }
    double less = run["DAM"].value_or(0);
    if (run.mode("AMODE", degression_digit) == 2) less = -std::fabs(less) / 100;  // a percentage is a factor
    const double least = std::fabs(run["MDEP"].value_or(0));
    const auto too_many = [&] {
      b.report(ig::diag("SIE-0195"), DrillingCall::where(run, "DAM"), name, static_cast<double>(most_strokes));
      return false;
    };
    // Known before a stroke is computed, unless a factor makes the strokes longer.
    const double longest = std::fmax(first, less > 0 ? less : least);
    if (less >= -1 && total > most_strokes * longest) return too_many();
    depths_.assign(1, first);
    double stroke = first;
    while (total - depths_.back() > rounding_mm) {
      const double left = total - depths_.back();
      if (less > 0 && stroke - less >= less - rounding_mm) {
        stroke -= less;
      } else if (less > 0) {
        stroke = left > 2 * less + rounding_mm ? less : left / 2;
        if (left <= 2 * less + rounding_mm) {  // the last two strokes are equal
          depths_.push_back(depths_.back() + stroke);
          depths_.push_back(total);
          break;
        }
      } else if (less < 0) {
        stroke = std::fmax(stroke * -less, least);
      }
      depths_.push_back(stroke < left - rounding_mm ? depths_.back() + stroke : total);
      if (depths_.size() > most_strokes) return too_many();
    }
    depths_.back() = total;
    return true;
  }
};

const ig::Register<SiemensDeepHoleCycle> siemens_deep_hole_cycle_syntax;

}  // namespace
}  // namespace siemens
