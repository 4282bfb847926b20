/// The feed in force: what F, G93, G94 and G95 and the spindle speed of this and earlier blocks amount to.
/// FeedrateSyntax uses it, the cycles, whose call may hold an F, and the motion syntaxes.
#pragma once

#include "isogloss/sdk.hpp"

#include <optional>

namespace ig::cnc {

inline const Diagnostics feed_diagnostics{
    diagnostic(
        IG_ERROR, "ISO-0210", "F{0} is not greater than zero: the previous feed rate stays in force",
        "A control stops at the next feed move after F0 or a negative F. This word does not change the feed rate here.",
        "G01 X10. F0"),
    diagnostic(IG_ERROR, "ISO-0211",
               "feed move without a feed rate: {0} ended the feed rate in {1}, so program F again",
               "F200 is 200 mm/min under G94 and 200 mm/rev under G95. With the option mode-change=\"require-f\", "
               "a change of the mode ends the old feed rate: program F together with the new mode, or before the "
               "first feed move. The move is kept, without a feed rate.",
               "G95 (F100 before), then G01 X10."),
    diagnostic(IG_ERROR, "ISO-0302", "feed move without a feed rate: program F in this block or before it",
               "The control stops with an alarm. The move is kept without a feed rate, so cycle times are wrong. "
               "Under G93 every feed move needs an F of its own.",
               "G01 X10. (no F so far)"),
    diagnostic(IG_ERROR, "ISO-0303",
               "feed per revolution without a spindle speed: the axes would stand still, so program S first",
               "Under G95 the feed rate is F times the spindle speed.", "G95 G01 X10. F0.1 (no S so far)"),
};
/// A member of each syntax that moves by feed. A syntax that also calls resolve() declares FeedInForce{read | write}.
class FeedInForce {
 public:
  explicit FeedInForce(Access access = read)
      : value_("Feedrate.FeedrateValue", access),
        term_("Feedrate.Term", access),
        unit_("Feedrate.Unit", access),
        ended_unit_("Feedrate.EndedUnit", access,
                    {Life::modal, "", "What the feed counted that G94 or G95 ended; gone with the next F."}) {}

  /// Makes F the modal feed, in the mode in force (G94 where there is none). Without F nothing changes; an F of 0 or
  /// less is reported at `where` (ISO-0210) and changes nothing.
  void resolve(Block& b, std::optional<double> f, Where where = Where::block()) const {
    if (!f) return;
    if (*f <= 0) {
      b.report(diag("ISO-0210"), where, *f);
      return;
    }
    b.set(value_, *f);
    if (b.has(ended_unit_)) b.erase(ended_unit_);
    if (!b.has(term_)) set_mode(b, g94_);
  }

  /// Sets the mode, one of G93, G94 and G95, and its unit.
  void set_mode(Block& b, Symbol term) const {
    b.set(term_, term);
    b.set(unit_, term == g93_ ? per_minute_ : term == g95_ ? mm_per_revolution_ : mm_per_minute_);
  }

  /// Ends the feed: from here on none is in force, until the next F.
  void forget(Block& b) const { b.erase(value_); }

  /// Like forget(), for a change of mode: the unit of the ended feed is kept, so that the first feed move without F can
  /// name the reason.
  void end(Block& b) const {
    if (const auto unit = b.get(unit_)) b.set(ended_unit_, *unit);
    forget(b);
  }

  /// Reports why a feed move has no feed: ISO-0303 where the feed is per revolution and the spindle has no speed,
  /// ISO-0211 where a change of mode ended the feed, else ISO-0302.
  void report_missing(Block& b) const {
    if (value(b))
      b.report(diag("ISO-0303"), Where::block());
    else if (const auto unit = b.get(ended_unit_))
      b.report(diag("ISO-0211"), Where::block(), b.text(mode(b)), b.text(*unit));
    else
      b.report(diag("ISO-0302"), Where::block());
  }

  /// F as programmed, in mm/min, mm/rev or 1/min by mode; nothing where none is in force.
  std::optional<double> value(const Block& b) const { return b.get(value_); }
  /// The mode in force; G94 where no block has set one.
  Symbol mode(const Block& b) const { return b.get_or(term_, static_cast<Symbol>(g94_)); }
  bool is_inverse_time(const Block& b) const { return b.is(term_, g93_); }

  /// The feed along a path in mm/s; 0 where none is in force (no F yet, or G95 without a spindle speed). `length()`
  /// gives the length of the path in mm and is called only where the feed depends on it (G93).
  template <class Length>
  double mmds(const Block& b, const Length& length) const {
    const auto f = b.get(value_);
    if (!f) return 0;
    const Symbol term = mode(b);
    if (term == g95_) return *f * b.get_or(spindle_speed_, 0.0) / 60;
    if (term == g93_) return *f * length() / 60;
    if (*f != per_minute_before_) {
      per_minute_before_ = *f;
      per_second_before_ = *f / 60;
    }
    return per_second_before_;
  }

 private:
  Field<double> value_;
  Field<Symbol> term_;
  Field<Symbol> unit_;
  Field<Symbol> ended_unit_;
  mutable double per_minute_before_ = 0, per_second_before_ = 0;  // most blocks have the feed of the block before
  In<double> spindle_speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  Name g93_{"G93"}, g94_{"G94"}, g95_{"G95"};
  Name per_minute_{"1/min"}, mm_per_minute_{"mm/min"}, mm_per_revolution_{"mm/rev"};
};

}  // namespace ig::cnc
