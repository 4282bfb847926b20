/// G20 and G21 (G70 and G71): inch or metric input. It is the first syntax of the logic: in inch blocks it converts the
/// programmed lengths and feeds into mm, in place, so that no later syntax has to know of inches.
#include <algorithm>
#include <cmath>

#include <isogloss/cnc/cycle_codes.hpp>
#include <isogloss/cnc/cycle_in_force.hpp>
#include <isogloss/cnc/cycle_letters.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

#include "reading/unit_codes.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct UnitMode {
  static constexpr auto spec = ig::syntax("UnitModeSyntax", "G20/G21 inch or metric input; lengths become mm.")
                                   .after("ParameterizedFlagSyntax", "DecimalPointSyntax")
                                   .before("FeedrateSyntax", "CannedCycleResolveSyntax", "ProgramXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0117", "{0}: this number of inches is too large, so the word is not executed"),
      ig::diagnostic(IG_WARNING, "ISO-0373",
                     "{0} before any G20 or G21: lengths are read as {1}, so program the unit first"),
      ig::diagnostic(IG_ERROR, "ISO-0560",
                     "{0}: earlier lengths are in {1}, and this control cannot change its unit, so it stops"),
  };

  UnitCodes modes_{ig::take | ig::wake};
  ig::Fields lengths_{"lengths", "Parsing.**{mm} Parsing.**{mm/min}", ig::read | ig::write,
                      "The words that are lengths or feeds."};
  ig::Out<ig::Symbol> term_{"Unit.Term"};
  ig::InWhile<ig::Symbol> system_{"Unit.System", "Inch", ig::write};

  // F under G93 is a time, and K of a repeated canned cycle a count: neither is a length.
  ig::Codes feed_modes_{{"G93", "G94", "G95"}, ig::read};
  ig::In<ig::Symbol> feed_mode_{"Feedrate.Term"};
  CycleInForce cycle_;
  CycleK cycle_k_;
  TappingJ tapping_j_;
  CycleCalls cycle_ks_{"K[1]", ig::read | ig::write};
  ig::Name g20_{"G20"}, inch_{"Inch"}, metric_{"Metric"}, g93_{"G93"};

  enum class Unsaid { silent, warning };
  ig::Choice<Unsaid> unsaid_{
      "unsaid", "silent|warning", "silent",
      "Whether a length before any G20 or G21, whose unit is a setting of the machine, causes a warning."};
  enum class Effect { select, check };
  ig::Choice<Effect> effect_{"effect", "select|check", "select",
                             "Whether the codes select the unit, or only check it: a parameter of the machine sets the "
                             "unit, and the other code is an alarm."};
  ig::Config format_{"isogloss.number-format/1", ig::Need::optional, "The unit in which a program starts."};
  ig::Signal no_unit_yet_{"Unit.~Unsaid", ig::read | ig::write | ig::wake_while, ig::Life::modal};

  UnitMode() {
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      if (lengths_.unit(i) == "mm/min") feeds_.push_back(lengths_.id(i));
      if (lengths_.path(i) == "Parsing.K") k_ = lengths_.id(i);
      if (lengths_.path(i) == "Parsing.J") j_ = lengths_.id(i);
      for (const std::string_view cycle : TappingJ::cycles)
        if (tapping_j_.is_ratio() && ig::word_name(lengths_.path(i)) == std::string(cycle) + ".J")
          ratios_.push_back(lengths_.id(i));
    }
  }

  ig::Status restart(ig::Block& b) {
    const bool in_inch = format_.number("StartsInInch").value_or(0) != 0;
    if (in_inch) {
      b.set(term_, g20_);
      b.set(system_, inch_);
    }
    if (unsaid_ == Unsaid::silent && effect_ == Effect::select)
      return in_inch ? ig::Status::changed : ig::Status::unchanged;
    b.raise(no_unit_yet_);
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    const auto mode = modes_.take(b);
    const bool waits_for_unit = b.is_raised(no_unit_yet_);
    const bool is_reported = waits_for_unit && (mode || report_missing_unit(b));
    if (is_reported) b.erase(no_unit_yet_);
    if (mode && effect_ == Effect::check && !waits_for_unit && b.is(system_, mode->is_inch ? metric_ : inch_)) {
      b.report(ig::diag("ISO-0560"), ig::Where::block(), b.text(mode->name),
               std::string_view(mode->is_inch ? "mm" : "inches"));
      b.alarm();
    } else if (mode) {
      b.set(term_, mode->name);
      b.set(system_, mode->is_inch ? inch_ : metric_);
    }
    const bool converted = b.is(system_, inch_) && to_metric(b);
    return mode || converted || is_reported ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// True at the first length other than 0 of a program that has not selected a unit, which is reported there by
  /// option: in the other unit the program would move 25.4 times as far, or as little.
  bool report_missing_unit(ig::Block& b) const {
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      ig_value value;
      if (!b.get(lengths_.id(i), value) || value.number == 0) continue;
      if (unsaid_ == Unsaid::warning)
        b.report(ig::diag("ISO-0373"), ig::Where::word(lengths_.id(i)), ig::word_name(lengths_.path(i)),
                 std::string_view(b.is(system_, inch_) ? "inches" : "mm"));
      return true;
    }
    return false;
  }

  bool to_metric(ig::Block& b) const {
    const bool inverse_time = is_inverse_time(b);
    const bool in_cycle = cycle_.is_on(b);
    const bool k_is_count = !cycle_k_.is_length() && in_cycle;
    const bool j_is_ratio = in_cycle && tapping_j_.is_ratio(b);
    bool any = false;
    for (std::uint32_t row = 0; row < cycle_ks_.code_count() && cycle_k_.is_length(); ++row) {
      const ig_field k = cycle_ks_.word(row, 'K');
      ig_value value;
      if (!b.get(k, value)) continue;
      any = true;
      convert(b, k, value.number, "K");
    }
    ig_value values[32];
    for (std::size_t at = 0; at < lengths_.size(); at += 32) {
      const auto n = static_cast<std::uint32_t>(std::min<std::size_t>(32, lengths_.size() - at));
      const ig_field* const ids = lengths_.ids() + at;
      const std::uint32_t found = b.get_many(ids, n, values);
      for (std::uint32_t i = 0; i < n; ++i) {
        if ((found >> i & 1u) == 0) continue;
        if ((k_is_count && ids[i] == k_) || (j_is_ratio && ids[i] == j_)) continue;
        if (std::find(ratios_.begin(), ratios_.end(), ids[i]) != ratios_.end()) continue;
        if (inverse_time && std::find(feeds_.begin(), feeds_.end(), ids[i]) != feeds_.end()) continue;
        any = true;
        convert(b, ids[i], values[i].number, ig::word_name(lengths_.path(at + i)));  // "Parsing."
      }
    }
    return any;
  }

  static void convert(ig::Block& b, ig_field word, double inches, std::string_view name) {
    if (const double mm = inches * mm_per_inch; std::isfinite(mm)) {
      b.rewrite(word, mm);
    } else {
      b.report(ig::diag("ISO-0117"), ig::Where::word(word), name);
      b.erase(word);
    }
  }

  bool is_inverse_time(const ig::Block& b) const {
    const auto mode = b.find(feed_modes_);
    return mode ? feed_modes_.name(*mode) == g93_ : b.is(feed_mode_, g93_);
  }

  std::vector<ig_field> feeds_;
  std::vector<ig_field> ratios_;
  ig_field k_ = IG_NO_FIELD, j_ = IG_NO_FIELD;
};

const ig::Register<UnitMode> unit_mode_syntax;

}  // namespace
}  // namespace iso
