/// The feed in force: what F, G93/G94/G95 and S of this and earlier blocks add up to. Used by FeedrateSyntax, by the
/// cycles, whose call may hold an F, and by the motions.
#pragma once

#include <isogloss/sdk.hpp>

#include <optional>

namespace iso {

/// A member of each syntax that moves by feed; one that also calls resolve() says FeedInForce{ig::read | ig::write}.
class FeedInForce {
 public:
  explicit FeedInForce(ig::Access access = ig::read)
      : value_("Feedrate.FeedrateValue", access),
        term_("Feedrate.Term", access),
        unit_("Feedrate.Unit", access),
        ended_unit_("Feedrate.EndedUnit", access,
                    {ig::Life::modal, "", "What the feed counted that G94 or G95 ended; gone with the next F."}) {}

  /// F becomes the modal feed, in the mode in force (G94 when none is). Nothing is written without F, nor for one that
  /// is no feed, which is said.
  void resolve(ig::Block& b, std::optional<double> f, ig::Where where = ig::Where::block()) const {
    if (!f) return;
    if (*f <= 0) {
      b.report(ig::diag("ISO-0210"), where, *f);
      return;
    }
    b.set(value_, *f);
    if (b.has(ended_unit_)) b.erase(ended_unit_);
    if (!b.has(term_)) set_mode(b, g94_);
  }

  /// G93, G94 or G95, and its unit.
  void set_mode(ig::Block& b, ig::Symbol term) const {
    b.set(term_, term);
    b.set(unit_, term == g93_ ? per_minute_ : term == g95_ ? mm_per_revolution_ : mm_per_minute_);
  }

  /// No feed is in force any more, until the next F.
  void forget(ig::Block& b) const { b.erase(value_); }

  /// As forget(), before the mode is set anew: the first feed move without F says why there is none.
  void end(ig::Block& b) const {
    if (const auto unit = b.get(unit_)) b.set(ended_unit_, *unit);
    forget(b);
  }

  /// No F is in force, or one for each revolution of a spindle that does not turn.
  void say_missing(ig::Block& b) const {
    if (value(b))
      b.report(ig::diag("ISO-0303"), ig::Where::block());
    else if (const auto unit = b.get(ended_unit_))
      b.report(ig::diag("ISO-0211"), ig::Where::block(), b.text(mode(b)), b.text(*unit));
    else
      b.report(ig::diag("ISO-0302"), ig::Where::block());
  }

  /// As programmed: mm/min, mm/rev or 1/min.
  std::optional<double> value(const ig::Block& b) const { return b.get(value_); }
  /// G94 where nothing was said.
  ig::Symbol mode(const ig::Block& b) const { return b.get_or(term_, static_cast<ig::Symbol>(g94_)); }
  bool is_inverse_time(const ig::Block& b) const { return b.is(term_, g93_); }

  /// mm/s along a path; 0 where no feed is in force (no F yet, G95 without a spindle speed). `length()` is the path's
  /// in mm, asked where the feed depends on it.
  template <class Length>
  double mmds(const ig::Block& b, const Length& length) const {
    const auto f = b.get(value_);
    if (!f) return 0;
    const ig::Symbol term = mode(b);
    if (term == g95_) return *f * b.get_or(spindle_speed_, 0.0) / 60;
    if (term == g93_) return *f * length() / 60;
    return *f / 60;
  }

 private:
  ig::Field<double> value_;
  ig::Field<ig::Symbol> term_;
  ig::Field<ig::Symbol> unit_;
  ig::Field<ig::Symbol> ended_unit_;
  ig::In<double> spindle_speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::Name g93_{"G93"}, g94_{"G94"}, g95_{"G95"};
  ig::Name per_minute_{"1/min"}, mm_per_minute_{"mm/min"}, mm_per_revolution_{"mm/rev"};
};

}  // namespace iso
