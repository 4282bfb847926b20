/// Arcs as Siemens writes them become the words that CircularMotionSyntax knows: AR= (the angle of the arc) and CIP (an
/// arc through a point). TURN= is kept for SiemensTurnSyntax, and CR= has been read as R.
#include <cmath>
#include <numbers>

#include <isogloss/cnc/arc.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

#include "frames/frame_shape.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensArc {
  static constexpr auto spec = ig::syntax("SiemensArcSyntax", "CR=, AR= and CIP become arcs with a centre.")
                                   .after("SiemensPositionSyntax", "PlaneSelectSyntax")
                                   .before("SiemensCycleSyntax", "ProgramXyzSyntax", "CircularMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0221",
                     "AR={0} is not the angle of an arc: program more than 0 and less than 360 degrees"),
      ig::diagnostic(IG_ERROR, "SIE-0222",
                     "AR= has its end point at the start, so there is no arc: program a full circle with I J K"),
      ig::diagnostic(IG_ERROR, "SIE-0223",
                     "CIP leaves the plane of G17, G18 or G19, so the arc is shown as a straight line"),
      ig::diagnostic(IG_ERROR, "SIE-0224",
                     "CIP is shown as a straight line: its three points lie on no circle, so check I1 J1 K1"),
      ig::diagnostic(
          IG_ERROR, "SIE-0227",
          "AR= is ignored, because the block also gives {0}: program it with an end point or a centre alone"),
      ig::diagnostic(IG_WARNING, "SIE-0225",
                     "an arc under unequal scales is no circle in the machine: scale both axes of the plane alike"),
      ig::diagnostic(IG_WARNING, "SIE-0290",
                     "CR={0} is ignored without G2 or G3: remove the word, or program the arc in this block"),
  };

  ig::Codes arcs_{{"G02", "G03"}, ig::read | ig::write | ig::wake};
  ig::Codes others_{{"G00", "G01", "G33"}, ig::read | ig::wake};
  ig::Codes cip_{"CIP"};
  ig::InWhile<ig::Symbol> clockwise_{"MotionState.Term", "G02"};
  ig::InWhile<ig::Symbol> counterclockwise_{"MotionState.Term", "G03"};
  ig::Signal through_{"MotionState.~ThroughPoint", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::Word cr_{"Parsing.CR", ig::wake, "mm"}, ar_{"Parsing.AR", ig::wake, "deg"};
  std::array<ig::Word, 3> middle_{ig::Word{"Parsing.I1", ig::take, "mm"}, ig::Word{"Parsing.J1", ig::take, "mm"},
                                  ig::Word{"Parsing.K1", ig::take, "mm"}};
  ig::Word r_{"Parsing.R", ig::read | ig::write};
  std::array<ig::Word, 3> centre_{ig::Word{"Parsing.I", ig::take | ig::write},
                                  ig::Word{"Parsing.J", ig::take | ig::write},
                                  ig::Word{"Parsing.K", ig::take | ig::write}};
  ig::Xyz words_{"Parsing", ig::read | ig::write};
  ig::Signal uneven_{"ProgrammableFrame.~Uneven", ig::read, ig::Life::modal};
  ig::Signal settable_uneven_{"WorkOffsetFrame.~Uneven", ig::read, ig::Life::modal};
  ig::Transform programmable_{"ProgrammableFrame", ig::read}, tilt_{"TiltTransform", ig::read},
      settable_{"WorkOffsetFrame", ig::read};
  PlaneInForce plane_;
  LastProgramXyz last_;
  ig::Name g02_{"G02"}, g03_{"G03"};
  ig::Signal radius_said_{"SiemensArc.~RadiusSaid", ig::read | ig::write, ig::Life::modal};

  ig::Status build(ig::Block& b) {
    const bool cip = b.take(cip_).has_value();
    if (cip) b.raise(through_);
    const auto arc = b.find(arcs_);
    const bool ends = !cip && b.is_raised(through_) && (arc || b.find(others_));
    if (ends) b.erase(through_);
    bool any = cip || ends;
    if (const auto cr = b.take(cr_)) {
      const bool is_arc = arc || (!b.find(others_) && (b.is(clockwise_, g02_) || b.is(counterclockwise_, g03_)));
      if (is_arc)
        b.set(r_, *cr);
      else if (!b.is_raised(radius_said_))
        b.report(ig::diag("SIE-0290"), ig::Where::word(cr_.id()), *cr);
      if (!is_arc) b.raise(radius_said_);
      any = true;
    }
    if (b.is_raised(through_)) return through_point(b, cip) || any ? ig::Status::changed : ig::Status::unchanged;
    if (b.find(others_)) return any ? ig::Status::changed : ig::Status::unchanged;
    const bool is_arc = arc || b.is(clockwise_, g02_) || b.is(counterclockwise_, g03_);
    if (is_arc && b.get(words_).mask != 0 && is_bent(b)) b.report(ig::diag("SIE-0225"), ig::Where::block());
    if (const auto angle = b.take(ar_)) {
      by_angle(b, *angle, arc ? *arc == 1 : b.is(counterclockwise_, g03_));
      any = true;
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// True where the frame distorts circles in the plane in force.
  bool is_bent(const ig::Block& b) const {
    if (!b.is_raised(uneven_) && !b.is_raised(settable_uneven_)) return false;
    return !keeps_circles(chained(b, {&programmable_, &tilt_, &settable_}), plane_(b));
  }

  void set(ig::Block& b, const PlaneAxes& plane, const Point2& from_start) const {
    b.set(centre_[plane.first], rounded(from_start.u));
    b.set(centre_[plane.second], rounded(from_start.v));
  }

  /// AR with the end point gives the centre; AR with the centre gives the end point. With both the arc is known without
  /// AR.
  void by_angle(ig::Block& b, double degrees, bool is_ccw) const {
    const auto where = ig::Where::word(ar_.id());
    if (!(degrees > 0 && degrees < 360)) {
      b.report(ig::diag("SIE-0221"), where, degrees);
      return;
    }
    const PlaneAxes plane = plane_(b);
    const ig::Vec3 from = last_(b);
    const ig::PartialVec3 named = b.get(words_);
    const bool has_centre = b.has(centre_[plane.first]) || b.has(centre_[plane.second]);
    const bool has_end = named.has(plane.first) || named.has(plane.second);
    if (b.has(r_) || (has_centre && has_end)) {
      const std::string_view others = b.has(r_) ? "the radius CR=" : "an end point and a centre";
      b.report(ig::diag("SIE-0227"), where, others);
      return;
    }
    const Point2 start{from[plane.first], from[plane.second]};
    const double turn = (is_ccw ? 1 : -1) * degrees * radians_per_degree;
    const auto i = b.get(centre_[plane.first]), j = b.get(centre_[plane.second]);
    if (i || j) {
      const Point2 c{start.u + i.value_or(0), start.v + j.value_or(0)}, out = start - c;
      set_word(b, plane.first, c.u + out.u * std::cos(turn) - out.v * std::sin(turn));
      set_word(b, plane.second, c.v + out.u * std::sin(turn) + out.v * std::cos(turn));
      return;
    }
    const ig::Vec3 to = named.or_else(from);
    const Point2 end{to[plane.first], to[plane.second]}, chord = end - start;
    if (chord.length() < same_point_mm) {
      b.report(ig::diag("SIE-0222"), where);
      return;
    }
    // The centre lies on the bisector of the chord, at half the chord over the tangent of half the angle.
    const double height = 0.5 / std::tan(turn / 2);
    set(b, plane, {chord.u / 2 - chord.v * height, chord.v / 2 + chord.u * height});
  }
  void set_word(ig::Block& b, std::size_t axis, double value) const { b.set(words_.id(axis), rounded(value)); }

  /// The circle through the start, I1 J1 K1 and the end. It must lie in the plane or rise evenly along the third axis.
  bool through_point(ig::Block& b, bool is_named) const {
    std::array<std::optional<double>, 3> word;
    for (std::size_t axis = 0; axis < 3; ++axis) word[axis] = b.take(middle_[axis]);
    const bool has_point = word[0] || word[1] || word[2];
    const ig::PartialVec3 named = b.get(words_);
    if (named.mask == 0 && !has_point) return false;
    const PlaneAxes plane = plane_(b);
    const ig::Vec3 from = last_(b), to = named.or_else(from);
    ig::Vec3 middle = from;
    for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = word[axis].value_or(from[axis]);
    const Point2 start{from[plane.first], from[plane.second]}, end{to[plane.first], to[plane.second]},
        point{middle[plane.first], middle[plane.second]};
    const Point2 a = point - start, c = end - start;
    const double area = 2 * (a.u * c.v - a.v * c.u);
    const bool leaves_plane = std::fabs(to[plane.tool] - from[plane.tool]) > same_point_mm ||
                              std::fabs(middle[plane.tool] - from[plane.tool]) > same_point_mm;
    const auto where = is_named ? ig::Where::word(cip_.id(0)) : ig::Where::block();
    const double a2 = a.u * a.u + a.v * a.v, c2 = c.u * c.u + c.v * c.v;
    const Point2 centre{(c.v * a2 - a.v * c2) / area, (a.u * c2 - c.u * a2) / area};
    const bool is_circle = std::fabs(area) >= 1e-9 && std::isfinite(centre.length());
    if (leaves_plane || !has_point || !is_circle) {
      b.report(leaves_plane ? ig::diag("SIE-0223") : ig::diag("SIE-0224"), where);
      b.raise(others_code());
      return true;
    }
    set(b, plane, centre);
    b.raise(arcs_.id(area > 0 ? 1 : 0));
    return true;
  }
  /// The code of a straight move, G01, to the end point.
  ig_field others_code() const { return straight_.id(0); }
  ig::Codes straight_{{"G01"}, ig::write};
};

const ig::Register<SiemensArc> siemens_arc_syntax;

}  // namespace
}  // namespace siemens
