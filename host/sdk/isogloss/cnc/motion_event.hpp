/// The motion of a block, and the motion code that it leaves in force.
#pragma once

#include "isogloss/sdk.hpp"

#include "isogloss/cnc/feed.hpp"
#include "isogloss/cnc/modal_group.hpp"

namespace ig::cnc {

/// The codes of group 01 that move the axes; the block's last one counts.
class MotionGroup {
 public:
  enum Index : std::size_t { g00, g01, g02, g03, g33 };

  /// The code of this block that counts, if there is one. Nothing is taken; `found` is how many there are.
  std::optional<std::size_t> find(const Block& b, std::uint32_t& found) const {
    const std::int32_t last = b.find_code(codes_.ids(), codes_.size(), &found);
    return last < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(last));
  }

  /// Takes what find() found, and makes `code` the motion in force.
  void take(Block& b, std::size_t code, std::uint32_t found) const {
    if (found == 1) {
      ig_value unused;
      b.take(codes_.id(code), unused);
    } else {
      b.take(codes_);
      b.report(diag("ISO-0201"), Where::word(codes_.id(code)), b.text(codes_.name(code)));
    }
    put_in_force(b, code);
  }
  void put_in_force(Block& b, std::size_t code) const { b.set(state_, codes_.name(code)); }

  /// Has a motion syntax before this one dealt with the block's code, or with the one in force?
  bool is_answered(const Block& b) const { return b.is_fresh(state_); }

  /// The code in force; G00 where nothing was said.
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

/// The motion of a block. An arc's centre is a program point, at the level of the arc's start.
class BlockMotion {
 public:
  /// One block never moves twice.
  bool is_moving(const Block& b) const { return b.has_any(compound_, form_); }

  /// Do the rotary axes turn under tool centre point control in this block?
  bool turns(const Block& b) const { return b.is_raised(turns_); }

  void rapid(Block& b) const {
    const ig_field fields[] = {form_.id(), is_rapid_.id()};
    const ig_value values[] = {symbol(straight_form(b)), {.integer = 1}};
    b.set_many(fields, 2, values);
  }
  /// `length()` is the path's, in mm; asked where the feed depends on it (G93).
  template <class Length>
  void feed(Block& b, const Length& length) const {
    const double mmds = feed_.mmds(b, length);
    const ig_field fields[] = {form_.id(), feedrate_.id()};
    const ig_value values[] = {symbol(straight_form(b)), {.number = mmds}};
    b.set_many(fields, mmds > 0 ? 2 : 1, values);
    if (mmds <= 0) say_no_feed(b);
  }
  template <class Length>
  void arc(Block& b, const Vec3& center, bool is_ccw, const Length& length) const {
    const double mmds = feed_.mmds(b, length);
    b.set(center_, center);
    const ig_field fields[] = {form_.id(), is_ccw_.id(), circles_.id(), feedrate_.id()};
    const ig_value values[] = {symbol(arc_), {.integer = is_ccw ? 1 : 0}, {.integer = 0}, {.number = mmds}};
    b.set_many(fields, mmds > 0 ? 4 : 3, values);
    if (mmds <= 0) say_no_feed(b);
  }
  /// By a feed of its own, in mm/s; 0: none is in force, which was said.
  void straight(Block& b, double feed_mmds) const {
    b.set(form_, straight_form(b));
    if (feed_mmds > 0) b.set(feedrate_, feed_mmds);
  }

 private:
  /// The tip is led along its path while the rotary axes turn.
  Symbol straight_form(const Block& b) const { return turns(b) ? led_ : linear_; }

  static ig_value symbol(Symbol s) { return ig::detail::ValueOf<Symbol>::write(s); }

  /// A feed move without a feed; under G93 a path without length needs none, and what G96 leaves unknown was said.
  void say_no_feed(Block& b) const {
    if (feed_.value(b) && (feed_.is_inverse_time(b) || b.is(speed_mode_, surface_))) return;
    feed_.say_missing(b);
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
