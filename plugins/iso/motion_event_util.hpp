/// The motion of a block, and the motion code that it leaves in force.
#pragma once

#include "diagnostics.hpp"
#include "feed_util.hpp"

namespace iso {

/// The codes of group 01 that move the axes; the block's last one counts.
class MotionGroup {
 public:
  enum Index : std::size_t { g00, g01, g02, g03, g33 };

  /// The code of this block that counts, if there is one. Nothing is taken.
  std::optional<std::size_t> find(const ig::Block& b) const { return b.find(codes_); }

  /// Takes all of them, and makes `code` the motion in force.
  void take(ig::Block& b, std::size_t code) const {
    std::uint32_t found = 0;
    b.take(codes_, &found);
    if (found > 1) b.report(diag("ISO-0201"), ig::Where::word(codes_.id(code)), b.text(codes_.name(code)));
    put_in_force(b, code);
  }
  void put_in_force(ig::Block& b, std::size_t code) const { b.set(state_, codes_.name(code)); }

  /// The code in force; G00 where nothing was said.
  std::size_t in_force(const ig::Block& b) const {
    const ig::Symbol term = b.get_or(state_, codes_.name(g00));
    std::size_t code = g00;
    while (code < g33 && codes_.name(code) != term) ++code;
    return code;
  }

 private:
  ig::Codes codes_{{"G00", "G01", "G02", "G03", "G33"}, ig::take};
  ig::Out<ig::Symbol> state_{"MotionState.Term"};
};

/// The motion of a block. An arc's centre is a program point, at the level of the arc's start.
class BlockMotion {
 public:
  /// One block never moves twice.
  bool is_moving(const ig::Block& b) const {
    const ig_field motions[] = {compound_.id(), form_.id()};
    ig_value unused[2];
    return b.host()->get_many(b.raw(), motions, 2, unused) != 0;
  }

  void rapid(ig::Block& b) const {
    b.set(form_, linear_);
    b.set(is_rapid_, true);
  }
  void feed(ig::Block& b, double length_mm) const {
    b.set(form_, linear_);
    set_feed(b, length_mm);
  }
  void arc(ig::Block& b, const ig::Vec3& center, bool is_ccw, double length_mm) const {
    b.set(form_, arc_);
    b.set(center_, center);
    b.set(is_ccw_, is_ccw);
    b.set(circles_, std::int64_t{0});
    set_feed(b, length_mm);
  }
  /// Does the feed depend on the length of the path (G93)?
  bool needs_length(const ig::Block& b) const { return feed_.is_inverse_time(b); }
  /// The feed of a path of that length; a feed move without a feed is said.
  void set_feed(ig::Block& b, double length_mm) const {
    const double mmds = feed_.mmds(b, length_mm);
    if (mmds > 0)
      b.set(feedrate_, mmds);
    else if (!needs_length(b) || !feed_.value(b))
      b.report(feed_.value(b) ? diag("ISO-0303") : diag("ISO-0302"), ig::Where::block());
  }

 private:
  ig::In<ig::Symbol> compound_{"CompoundMotion.Term"};
  ig::Out<ig::Symbol> form_{"MotionEvent.Form"};
  ig::Out<bool> is_rapid_{"MotionEvent.IsRapid"};
  ig::Out<double> feedrate_{"MotionEvent.Feedrate_mmds"};
  ig::Xyz center_{"MotionEvent.ArcCenter", ig::write};
  ig::Out<bool> is_ccw_{"MotionEvent.IsCcw"};
  ig::Out<std::int64_t> circles_{"MotionEvent.AdditionalCircleNum"};
  ig::Name linear_{"McLinear"}, arc_{"McArc"};
  FeedInForce feed_;
};

}  // namespace iso
