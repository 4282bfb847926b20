/// What G83 and G73 share besides what all cycles share: the pecks into which Q divides a hole, and the treatment of a
/// Q that gives none.
#pragma once

#include <isogloss/cnc/arc.hpp>
#include <isogloss/cnc/canned_cycle.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

/// The pecks of the holes of one block.
struct Pecks {
  PeckStrokes strokes;
  int count;           ///< strokes of one hole
  double retraction;   ///< mm: clearance before a peck (G83), way back after it (G73)
  double clear_level;  ///< where the chips come out: R, or a level above it
  double full_return;  ///< mm: G73 retracts fully after this depth; 0: never

  bool is_last(int k) const { return k == count; }
  double level(int k) const { return strokes.level(k, count); }
  /// The level above stroke k by the retraction; above R where the retraction is longer than the hole is deep there.
  double clear_of(int k) const { return strokes.above(level(k), retraction); }
};

/// A member of each peck cycle.
class PeckCycle {
 public:
  /// `retraction` is the name of the distance in the service isogloss.canned-cycle/1.
  explicit PeckCycle(const char* retraction) : config_("isogloss.canned-cycle/1", ig::Need::optional, retraction) {
    const auto answer = config_.number(retraction);
    if (answer && *answer >= 0)
      retraction_ = *answer;
    else if (config_)
      unknown_ = retraction;
  }

  /// The pecks of a hole; nothing, with a diagnostic, where Q gives none: the hole must then not be drilled.
  std::optional<Pecks> plan(ig::Block& b, const CannedCycle& cycle, const CycleRun& run) const {
    const double length = std::fabs(run.bottom - run.r_level);
    const double q = run.words.get_or(CycleWords::Q, 0);
    const bool is_news = !b.is(term_before_, run.code) || b.get_or(q_before_, 0.0) != q;
    if (const double first = first_by_i(run); first > 0) return plan_decreasing(b, cycle, run, first, is_news);
    double depth = std::fabs(q);
    if (depth == 0) {
      const bool is_one_stroke = missing_q_ == MissingQ::one_stroke;
      b.report(is_one_stroke ? ig::diag("ISO-0327") : ig::diag("ISO-0326"), cycle.where(run), b.text(run.code));
      if (!is_one_stroke) {
        b.alarm();
        return std::nullopt;
      }
      depth = std::max(length, PeckStrokes::least_stroke);
    } else if (q < 0 && is_news) {
      b.report(ig::diag("ISO-0328"), cycle.where(run, CycleWords::Q), b.text(run.code), depth);
    }
    const PeckStrokes strokes(run.r_level, run.bottom, depth);
    const double number = strokes.number();
    const double most = most_pecks(run.count);
    if (!(number <= most)) {  // written so that NaN is too many as well
      b.report(ig::diag("ISO-0329"), cycle.where(run, CycleWords::Q), b.text(run.code), depth, number, most);
      return std::nullopt;
    }
    if (is_news && q != 0) {
      if (!unknown_.empty()) b.report(ig::diag("ISO-0334"), cycle.where(run), b.text(run.code), unknown_, retraction_);
      if (retraction_ > depth + same_point_mm)
        b.report(ig::diag("ISO-0333"), cycle.where(run), b.text(run.code), retraction_, depth);
    }
    const double k = peck_words_ == PeckWords::q ? 0 : run.words.get_or(CycleWords::K, 0);
    if (k < 0 && is_news)
      b.report(ig::diag("ISO-0359"), cycle.where(run, CycleWords::K), b.text(run.code), std::string_view("K"), k);
    return Pecks{strokes, static_cast<int>(number), retraction_, clear_level(strokes, run), std::fabs(k)};
  }

  /// The letters of the call's words that define its pecks.
  std::string_view used(const CycleRun& run, std::string_view with_q, std::string_view with_ijk) const {
    return first_by_i(run) > 0 ? with_ijk : with_q;
  }

 private:
  enum class MissingQ { no_hole, one_stroke };
  enum class PeckWords { q, q_or_ijk };

  /// The first peck of a call with I, J and K; 0 where Q gives the pecks.
  double first_by_i(const CycleRun& run) const {
    const auto i = run.words[CycleWords::I];
    return i && peck_words_ == PeckWords::q_or_ijk ? std::fabs(*i) : 0;
  }

  double clear_level(const PeckStrokes& strokes, const CycleRun& run) const {
    return strokes.above(run.r_level, config_.number("PeckClearanceAboveR_mm").value_or(0));
  }

  /// The first peck is I, each later one is J shorter, down to K.
  std::optional<Pecks> plan_decreasing(ig::Block& b, const CannedCycle& cycle, const CycleRun& run, double first,
                                       bool is_news) const {
    constexpr std::array addresses{CycleWords::I, CycleWords::J, CycleWords::K};
    for (std::size_t i = 0; i < addresses.size() && is_news; ++i)
      if (const double value = run.words.get_or(addresses[i], 0); value < 0)
        b.report(ig::diag("ISO-0359"), cycle.where(run, addresses[i]), b.text(run.code),
                 std::string_view("IJK").substr(i, 1), value);
    const double less = std::fabs(run.words.get_or(CycleWords::J, 0));
    double least = std::fabs(run.words.get_or(CycleWords::K, 0));
    if (least == 0 && less > 0) {
      least = first - less * (std::ceil(first / less - 1e-9) - 1);
      if (is_news) b.report(ig::diag("ISO-0372"), cycle.where(run), b.text(run.code), least);
    }
    const PeckStrokes strokes(run.r_level, run.bottom, first, less, std::min(least, first));
    const double number = strokes.number();
    const double most = most_pecks(run.count);
    if (!(number <= most)) {
      b.report(ig::diag("ISO-0329"), cycle.where(run), b.text(run.code), less > 0 ? least : first, number, most);
      return std::nullopt;
    }
    return Pecks{strokes, static_cast<int>(number), retraction_, clear_level(strokes, run), 0};
  }

  /// The largest number of pecks of one hole. A peck is three steps, a hole four more, and the steps of a block must
  /// fit into the host's list.
  double most_pecks(int holes) const {
    const auto allowed = static_cast<double>(static_cast<std::int64_t>(max_pecks_));
    return std::min(allowed, std::floor((static_cast<double>(most_steps) / holes - 4) / 3));
  }

  ig::Config config_;
  double retraction_ = 5;  // the default of FallbackConfig, where no dependency answers
  std::string_view unknown_;
  ig::Previous<ig::Symbol> term_before_{"CannedCycle.Term"};
  ig::Previous<double> q_before_{"CannedCycle.Params.Q"};
  ig::Choice<MissingQ> missing_q_{"missing-q", "no-hole|one-stroke", "no-hole",
                                  "What a call without Q, or with Q0, does."};
  ig::Choice<PeckWords> peck_words_{
      "peck-words", "q|q-or-ijk", "q",
      "The words of the pecks: Q; or Q, or I (first peck), J (reduction) and K (smallest peck)."};
  ig::IntegerOption max_pecks_{"max-pecks", "10000", {1, 30'000}, "The largest number of pecks in one hole."};
};

/// A member of each peck cycle: P as a dwell, at the bottom of the hole or of each peck.
class PeckDwell {
 public:
  bool is_used() const { return after_ != After::none; }
  void dwell(ig::CompoundSteps& steps, const CycleRun& run, bool is_last) const {
    const double seconds = is_used() && (is_last || after_ == After::every_peck) ? dwell_.seconds(run) : 0;
    if (seconds > 0) steps.dwell(seconds);
  }

 private:
  enum class After { none, bottom, every_peck };
  CycleDwell dwell_;
  ig::Choice<After> after_{"dwell", "none|bottom|every-peck", "none",
                           "Whether P is a dwell time: never, after the last peck, or after each peck."};
};

}  // namespace iso
