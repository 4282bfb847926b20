/// The single motion of a block (section MotionEvent) and the motion code in force (section MotionState).
#pragma once

#include "isogloss/sdk.hpp"

#include "isogloss/cnc/feed.hpp"
#include "isogloss/cnc/modal_group.hpp"

namespace ig::cnc {

/// The codes of group 01 that move the axes; where a block holds several, the last one is in force.
class MotionGroup {
 public:
  enum Index : std::size_t { g00, g01, g02, g03, g33 };

  /// The index of the block's last motion code, without taking it; `found` receives how many the block holds.
  std::optional<std::size_t> find(const Block& b, std::uint32_t& found) const {
    const std::int32_t last = b.find_code(codes_.ids(), codes_.size(), &found);
    return last < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(last));
  }

  /// Takes the codes that find() found and puts `code` in force. Reports ISO-0201 where there was more than one.
  void take(Block& b, std::size_t code, std::uint32_t found) const {
    take_codes(b, code, found);
    put_in_force(b, code);
  }
  /// Like take(), for a motion that puts the code in force by its entry().
  void take_codes(Block& b, std::size_t code, std::uint32_t found) const {
    if (found == 1) {
      ig_value unused;
      b.take(codes_.id(code), unused);
    } else {
      b.take(codes_);
      b.report(diag("ISO-0201"), Where::word(codes_.id(code)), b.text(codes_.name(code)));
    }
  }
  void put_in_force(Block& b, std::size_t code) const { b.set(state_, codes_.name(code)); }

  /// What put_in_force() sets, for a motion that sets it together with its own values.
  struct Entry {
    ig_field field = IG_NO_FIELD;
    ig_value value{};
  };
  Entry entry(std::size_t code) const { return {state_.id(), ig::detail::ValueOf<Symbol>::write(codes_.name(code))}; }

  /// True when an earlier motion syntax has dealt with the block's code, or with the code in force.
  bool is_answered(const Block& b) const { return b.is_fresh(state_); }

  /// The code in force; G00 where no block has set one, and the last of the group for a term that is not of it.
  std::size_t in_force(const Block& b) const {
    const Symbol term = b.get_or(state_, codes_.name(g00));
    if (term == codes_.name(g01)) return g01;
    std::size_t code = g00;
    while (code < g33 && codes_.name(code) != term) ++code;
    return code;
  }

 private:
  Codes codes_{{"G00", "G01", "G02", "G03", "G33"}, ig::take};
  Out<Symbol> state_{"MotionState.Term"};
};

/// The motion of a block: rapid, feed or arc. Points in mm of program coordinates; an arc's centre lies at the level of
/// the arc's start.
class BlockMotion {
 public:
  /// True when the block already has a motion, single or compound. A motion syntax then does nothing.
  bool is_moving(const Block& b) const { return b.has_any(compound_, form_); }

  /// True when the rotary axes turn under tool centre point control in this block.
  bool turns(const Block& b) const { return b.is_raised(turns_); }

  void rapid(Block& b, const MotionGroup::Entry& code = {}) const {
    const ig_field fields[] = {code.field, form_.id(), is_rapid_.id()};
    const ig_value values[] = {code.value, symbol(straight_form(b)), {.integer = 1}};
    b.set_many(fields, 3, values);
  }
  /// A straight move by the feed in force. `length()` gives the length of the path in mm and is called only where the
  /// feed depends on it (G93). A missing feed is reported.
  template <class Length>
  void feed(Block& b, const Length& length, const MotionGroup::Entry& code = {}) const {
    const double mmds = feed_.mmds(b, length);
    const ig_field fields[] = {code.field, form_.id(), feedrate_.id()};
    const ig_value values[] = {code.value, symbol(straight_form(b)), {.number = mmds}};
    b.set_many(fields, mmds > 0 ? 3 : 2, values);
    if (mmds <= 0) report_no_feed(b);
  }
  /// An arc by the feed in force, otherwise like feed().
  template <class Length>
  void arc(Block& b, const Vec3& center, bool is_ccw, const Length& length) const {
    const double mmds = feed_.mmds(b, length);
    b.set(center_, center);
    const ig_field fields[] = {form_.id(), is_ccw_.id(), circles_.id(), feedrate_.id()};
    const ig_value values[] = {symbol(arc_), {.integer = is_ccw ? 1 : 0}, {.integer = 0}, {.number = mmds}};
    b.set_many(fields, mmds > 0 ? 4 : 3, values);
    if (mmds <= 0) report_no_feed(b);
  }
  /// A straight move by a feed of the caller's, in mm/s; 0: no feed is in force, and the caller has reported it.
  void straight(Block& b, double feed_mmds) const {
    b.set(form_, straight_form(b));
    if (feed_mmds > 0) b.set(feedrate_, feed_mmds);
  }

 private:
  /// While the rotary axes turn under tool centre point control, the control leads the tip along its path.
  Symbol straight_form(const Block& b) const { return turns(b) ? led_ : linear_; }

  static ig_value symbol(Symbol s) { return ig::detail::ValueOf<Symbol>::write(s); }

  /// Reports a missing feed. Not under G93, where a path without length needs none, and not under G96, where the
  /// missing spindle speed has been reported.
  void report_no_feed(Block& b) const {
    if (feed_.value(b) && (feed_.is_inverse_time(b) || b.is(speed_mode_, surface_))) return;
    feed_.report_missing(b);
  }

  In<Symbol> compound_{"CompoundMotion.Term"};
  Out<Symbol> form_{"MotionEvent.Form"};
  Out<bool> is_rapid_{"MotionEvent.IsRapid"};
  Out<double> feedrate_{"MotionEvent.Feedrate_mmds"};
  Xyz center_{"MotionEvent.ArcCenter", write};
  Out<bool> is_ccw_{"MotionEvent.IsCcw"};
  Out<std::int64_t> circles_{"MotionEvent.AdditionalCircleNum"};
  Signal turns_{"PivotTransform.~Turns", read};
  In<Symbol> speed_mode_{"SpindleSpeed.Term"};
  Name surface_{"G96"};
  Name linear_{"McLinear"}, arc_{"McArc"}, led_{"ClLinear"};
  FeedInForce feed_;
};

}  // namespace ig::cnc
