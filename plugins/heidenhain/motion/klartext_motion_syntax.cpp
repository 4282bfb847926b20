// The meaning of the words of a path block: increments become positions, polar coordinates become rectangular ones, the
// pole CC becomes the centre of an arc, and CT finds its own centre. From here on the block is one of G00 to G03, as in
// the other languages.
#include <numbers>

#include <isogloss/cnc/arc.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>
#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

#include "motion/klartext_departure.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextMotion {
  static constexpr auto spec =
      ig::syntax("KlartextMotionSyntax", "Increments, polar coordinates and tangents become a path.")
          .after("KlartextPathSyntax", "KlartextRotaryStepSyntax", "KlartextPoleSyntax", "UnitModeSyntax",
                 "PlaneSelectSyntax")
          .before("ProgrammableMirrorSyntax", "KlartextDrillingCycleSyntax", "MachineCoordSelectSyntax",
                  "ProgramXyzSyntax", "McAbcSyntax", "CircularMotionSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0132", "{0} needs a pole, so the block does not move: program CC before it"),
      ig::diagnostic(IG_ERROR, "HEI-0134", "{0} has no tangent: no path comes before it, or it goes straight back"),
      ig::diagnostic(IG_ERROR, "HEI-0137",
                     "the signs of IPA and DR differ, so {0} turns in the direction of DR: correct one of them"),
      ig::diagnostic(IG_ERROR, "HEI-0182",
                     "{0} would begin, turn or end more than 1000 km away, so the block does not move"),
  };

  ig::In<ig::Symbol> function_{"KlartextPath.Function", ig::wake};
  ig::In<bool> is_ccw_{"KlartextPath.IsCcw"};
  ig::Xyz words_{"Parsing", ig::read | ig::write | ig::take};
  std::array<ig_field, 3> steps_{step("IX", "mm"), step("IY", "mm"), step("IZ", "mm")};
  std::array<ig_field, 4> polar_{step("PR", "mm"), step("PA", "deg"), step("IPR", "mm"), step("IPA", "deg")};
  std::array<ig_field, 3> rotary_{rotary("Parsing.A"), rotary("Parsing.B"), rotary("Parsing.C")};
  std::array<ig_field, 3> centers_{center("Parsing.I"), center("Parsing.J"), center("Parsing.K")};
  ig::Codes motions_{{"G00", "G01", "G02", "G03"}, ig::read | ig::write};
  ig::Xyz pole_{"KlartextPath.Pole", ig::read, {ig::Life::modal, "mm", "The pole CC, in its plane."}};
  ig::Xyz tangent_{"KlartextPath.Tangent",
                   ig::read | ig::write,
                   {ig::Life::modal, "", "Where the path before goes on to: a unit vector."}};
  ig::Out<std::int64_t> circles_{"KlartextPath.Circles", {ig::Life::block, "", "Whole circles of CP beyond the arc."}};
  PlaneInForce plane_;
  LastProgramXyz last_;
  ig::In<bool> to_limit_{"KlartextPath.RetractsToLimit",
                         ig::read,
                         {ig::Life::block, "", "M140 MB MAX: along the tool axis to the end of the travel."}};
  ig::Word distance_{"Parsing.MB", ig::take, "mm", "M140 MB: how far along the tool axis."};
  ig::Service<ig_machine_axis_1> machine_{"isogloss.machine-axis/1", ig::Need::optional, "The travel of Z, for M140."};
  KlartextDeparture departure_{ig::read};
  ContourDeparture leave_{ig::write};
  ig::In<ig::Symbol> side_{"RadiusCompensation.Term"};
  ig::In<double> tool_radius_{"RadiusCompensation.Radius_mm"};
  ig::Name g41_{"G41"}, g42_{"G42"};
  ScaleAndMirror mirror_;
  ig::In<ig::Symbol> mirror_term_{"MirrorImage.Term"};
  ig::Out<bool> in_plane_{"KlartextPath.IsFeedInPlane", {ig::Life::block, "", "The move may end in a corner."}};
  ig::Signal open_{"KlartextCorner.~Open", ig::read | ig::write, ig::Life::modal};
  ig::Name lp_{"LP"}, c_{"C"}, cc_{"CC"}, cr_{"CR"}, ct_{"CT"}, cp_{"CP"}, ctp_{"CTP"}, rnd_{"RND"};

  ig::Status build(ig::Block& b) {
    const ig::Symbol function = b.get_or(function_, ig::Symbol{});
    if (!b.has(function_) || function == cc_) return ig::Status::unchanged;
    const ig::PartialVec3 named = b.get(words_);
    ig_value steps[3];
    const std::uint32_t has_steps = b.take_many(steps_.data(), 3, steps);

    Way way{plane_(b), start(b), {}, named.mask | has_steps, function};
    way.to = named.or_else(way.from);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((has_steps >> axis & 1u) != 0) way.to[axis] = way.from[axis] + steps[axis].number;
    const bool is_polar = function == lp_ || function == cp_ || function == ctp_;
    if (is_polar && !resolve_polar(b, way)) return drop(b);
    if (retracts(b)) retract(b, way);
    if (const auto off = departure_.get(b)) depart(b, way, *off);
    const bool is_computed = is_polar || has_steps != 0 || named.mask == 0 || function == c_ || function == ct_;
    if (is_computed && !(is_position(way.from) && is_position(way.to))) {
      b.report(ig::diag("HEI-0182"), ig::Where::block(), b.text(function));
      return drop(b);
    }
    if (way.mask == 0 && function != c_) return ig::Status::changed;
    if (is_polar || has_steps != 0 || function == c_) put(b, way);
    if (way.to[way.plane.tool] == way.from[way.plane.tool] && can_end_in_corner(b)) {
      b.set(in_plane_, true);
      b.raise(open_);
    } else if (b.is_raised(open_)) {
      b.erase(open_);
    }

    if (function == c_ || function == cp_) return about_pole(b, way);
    if (function == ct_ || function == ctp_)
      along_tangent(b, way);
    else if (function == cr_)
      keep_tangent_of_radius(b, way);
    else
      keep_tangent(b, way.to - way.from);
    return ig::Status::changed;
  }

 private:
  struct Way {
    PlaneAxes plane;
    ig::Vec3 from, to;
    std::uint32_t mask;  // the axes that the block moves
    ig::Symbol function;
    Point2 start() const { return {from[plane.first], from[plane.second]}; }
    Point2 end() const { return {to[plane.first], to[plane.second]}; }
    void set_end(const Point2& p) {
      to[plane.first] = p.u;
      to[plane.second] = p.v;
      mask |= 1u << plane.first | 1u << plane.second;
    }
  };

  /// The start of the block in coordinates of the program, before mirror images, which come after this syntax.
  ig::Vec3 start(ig::Block& b) const {
    const ig::Vec3 last = last_(b);
    return b.has(mirror_term_) ? rounded(mirror_.programmed(b, last)) : last;
  }

  static ig_field step(std::string_view name, const char* unit) {
    return ig::detail::declare_field({{"Parsing.", name}, IG_NUMBER, ig::take, {ig::Life::word, unit, ""}});
  }
  static ig_field rotary(const char* path) {
    return ig::Field<double>(path, ig::read, {ig::Life::standard, "deg", ""}).id();
  }
  static ig_field center(const char* path) {
    return ig::Field<double>(path, ig::read | ig::write, {ig::Life::standard, "mm", ""}).id();
  }

  /// True for a feed move without rotary axes: KlartextCornerSyntax looks for RND and CHF after it.
  bool can_end_in_corner(const ig::Block& b) const {
    const auto code = b.find(motions_);
    if (!code || *code == 0) return false;
    ig_value unused;
    for (const ig_field axis : rotary_)
      if (b.get(axis, unused)) return false;
    return true;
  }

  /// Writes positions into the block; an axis that it does not move gets no word.
  void put(ig::Block& b, const Way& way) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((way.mask >> axis & 1u) != 0) b.set(words_.id(axis), rounded(way.to[axis]));
  }

  bool retracts(const ig::Block& b) const { return b.has(to_limit_) || b.has(distance_); }

  /// M140: a retract along the tool axis. The end of the travel is known where that is Z of the machine.
  void retract(ig::Block& b, Way& way) const {
    const auto distance = b.take(distance_);
    const auto say = [&](std::string_view why) {
      b.report(ig::diag("HEI-0139"), ig::Where::block(), std::string_view("M140"), why);
    };
    if (way.mask != 0) return say("the retract after the other move of the block is missing");
    ig::Vec3 out = way.from;
    if (distance) {
      out[way.plane.tool] += *distance;
    } else {
      ig::Vec3 beyond = way.from;
      beyond[way.plane.tool] += 1;
      const auto here = b.to_machine(last_(b)), there = b.to_machine(beyond);
      double minimum = 0, maximum = 0;
      const bool known = machine_ && machine_->travel(machine_->self, 'Z', &minimum, &maximum) != 0;
      if (!known || !here || !there || std::fabs(there->z - here->z - 1) > 1e-9)
        return say("the retract is missing: where the travel of the tool axis ends is not known");
      out[way.plane.tool] += std::fmax(0, maximum - here->z);
    }
    way.to = out;
    way.mask = 1u << way.plane.tool;
    put(b, way);
  }

  /// DEP: departs from the contour, from the tool centre's position at its last point, to the side of RL or RR.
  void depart(ig::Block& b, Way& way, const KlartextDeparture::Way& off) const {
    using Shape = KlartextDeparture::Shape;
    const ig::PartialVec3 known = b.get(tangent_);
    const Point2 t{known.value[way.plane.first], known.value[way.plane.second]};
    const bool is_beside = b.is(side_, g41_) || b.is(side_, g42_);
    const bool is_arc = off.shape == Shape::arc || off.shape == Shape::line_and_arc;
    const auto say = [&](std::string_view why) {
      b.report(ig::diag("HEI-0130"), ig::Where::block(), std::string_view("DEP"), why);
    };
    if (!known.complete() || std::fabs(t.length() - 1) > 1e-6) return say("no move in the plane came before");
    if (is_arc && b.has(mirror_term_)) return say("in a mirror image the tool leaves straight");
    const double left = b.is(side_, g42_) ? -1 : 1, radius = is_beside ? b.get_or(tool_radius_, 0.0) : 0;
    if (is_arc && !(radius > 0)) return say("the tool has no radius, it leaves straight");
    const Point2 n{-t.v * left, t.u * left}, contour = way.start();
    const Point2 from{contour.u + radius * n.u, contour.v + radius * n.v};
    if (off.shape == Shape::line)
      way.set_end({from.u + off.length * t.u, from.v + off.length * t.v});
    else if (off.shape == Shape::normal)
      way.set_end({from.u + off.length * n.u, from.v + off.length * n.v});
    if (is_arc) {
      const double r = off.shape == Shape::arc ? off.radius : std::fabs(off.radius);
      const Point2 center{from.u + r * n.u, from.v + r * n.v};
      const bool is_ccw = (left > 0) == (r > 0);
      Point2 end = ContourApproach::turned(from, center, is_ccw ? off.angle_deg : -off.angle_deg);
      if (off.shape == Shape::line_and_arc) {
        // Seen from its end, the arc turns the other way.
        const auto touching = ContourApproach::touching(way.end(), center, r, !is_ccw);
        if (!touching) return say("its end lies inside the arc, the tool leaves straight");
        end = *touching;
      } else {
        way.set_end(end);
      }
      const auto at = [&](const Point2& p) {
        ig::Vec3 out = way.from;
        out[way.plane.first] = rounded(p.u);
        out[way.plane.second] = rounded(p.v);
        return out;
      };
      leave_.set(b, {at(center), at(end), is_ccw});
    }
    put(b, way);
  }

  /// False for positions farther away than any machine, whose results would lose all digits.
  static bool is_position(const ig::Vec3& p) {
    constexpr double farthest = 1e9;
    return std::fabs(p.x) < farthest && std::fabs(p.y) < farthest && std::fabs(p.z) < farthest;
  }

  /// Drops the words of a block that has no meaning.
  ig::Status drop(ig::Block& b) const {
    b.take(words_);
    b.erase(in_plane_);
    return ig::Status::changed;
  }

  bool has_pole(ig::Block& b, const Way& way) const {
    if (b.get(pole_).complete()) return true;
    b.report(ig::diag("HEI-0132"), ig::Where::block(), b.text(way.function));
    return false;
  }
  Point2 pole(const ig::Block& b, const PlaneAxes& plane) const {
    const ig::Vec3 p = b.get(pole_).value;
    return {p[plane.first], p[plane.second]};
  }

  bool resolve_polar(ig::Block& b, Way& way) const {
    ig_value v[4];
    const std::uint32_t has = b.take_many(polar_.data(), 4, v);
    if (!has_pole(b, way)) return false;
    if (has == 0 && way.function != cp_) return true;
    const Point2 center = pole(b, way.plane), out = way.start() - center;
    double radius = out.length();
    double angle = radius > 0 ? std::atan2(out.v, out.u) / radians_per_degree : 0;
    if ((has & 1u) != 0) radius = v[0].number;
    if ((has & 4u) != 0) radius += v[2].number;
    const bool is_turn = (has & 8u) != 0;
    const double turned = is_turn ? v[3].number : 0;
    const bool has_angle = (has & 2u) != 0;
    if (has_angle) angle = v[1].number;
    const bool is_whole = is_turn && !has_angle && std::remainder(turned, 360.0) == 0 && (has & 5u) == 0;
    if (is_whole || (!has_angle && !is_turn && (has & 5u) == 0)) {
      way.set_end(way.start());
    } else {
      const Turn t = Turn::by(angle + turned);
      way.set_end({center.u + radius * t.cos, center.v + radius * t.sin});
    }
    if (is_turn && way.function == cp_) note_circles(b, way, center, turned);
    return true;
  }

  /// IPA may exceed a whole circle. Its sign is the sense of rotation.
  void note_circles(ig::Block& b, const Way& way, const Point2& center, double turned) const {
    const auto is_ccw = b.get(is_ccw_);
    if (!is_ccw || turned == 0) return;
    if ((turned > 0) != *is_ccw) {
      b.report(ig::diag("HEI-0137"), ig::Where::block(), b.text(way.function));
      return;
    }
    const double arc = std::fabs(sweep(way.start(), way.end(), center, *is_ccw)) * degrees_per_radian;
    const double more = std::round((std::fabs(turned) - arc) / 360);
    if (more >= 1) b.set(circles_, static_cast<std::int64_t>(std::min(more, 1e9)));
  }

  // ---- arcs

  ig::Status about_pole(ig::Block& b, const Way& way) const {
    const auto is_ccw = b.get(is_ccw_);
    if (!has_pole(b, way)) return drop(b);
    if (!is_position(b.get(pole_).value)) {
      b.report(ig::diag("HEI-0182"), ig::Where::block(), b.text(way.function));
      return drop(b);
    }
    if (is_ccw) arc(b, way, pole(b, way.plane), *is_ccw);
    return ig::Status::changed;
  }

  void arc(ig::Block& b, const Way& way, const Point2& center, bool is_ccw) const {
    const Point2 from = way.start();
    b.set(centers_[way.plane.first], center.u - from.u);
    b.set(centers_[way.plane.second], center.v - from.v);
    const Point2 out = way.end() - center;
    keep_tangent(b, in_space(way.plane, is_ccw ? Point2{-out.v, out.u} : Point2{out.v, -out.u}));
  }

  void raise(ig::Block& b, std::size_t motion) const { b.raise(motions_.id(motion)); }

  /// CT: the arc that continues the direction of the path before and ends at the point.
  void along_tangent(ig::Block& b, const Way& way) const {
    const ig::PartialVec3 known = b.get(tangent_);
    const Point2 way_in_plane = way.end() - way.start();
    const Point2 t{known.value[way.plane.first], known.value[way.plane.second]};
    const double length = way_in_plane.length(), t_length = t.length();
    if (!known.complete() || t_length < 1e-9 || length < same_point_mm) {
      b.report(ig::diag("HEI-0134"), ig::Where::block(), b.text(way.function));
      raise(b, 1);
      return keep_tangent(b, way.to - way.from);
    }
    const Point2 left{-t.v / t_length, t.u / t_length};
    const double aside = way_in_plane.u * left.u + way_in_plane.v * left.v;
    const double ahead = way_in_plane.u * t.u + way_in_plane.v * t.v;
    if (std::fabs(aside) < same_point_mm) {  // straight on; straight back is not an arc
      if (ahead < 0) b.report(ig::diag("HEI-0134"), ig::Where::block(), b.text(way.function));
      raise(b, 1);
      return keep_tangent(b, way.to - way.from);
    }
    const double radius = length * length / (2 * aside);
    raise(b, aside > 0 ? 3 : 2);
    arc(b, way, {way.start().u + radius * left.u, way.start().v + radius * left.v}, aside > 0);
  }

  void keep_tangent_of_radius(ig::Block& b, const Way& way) const {
    ig_value radius;
    const auto is_ccw = b.get(is_ccw_);
    if (!is_ccw || !b.get(radius_, radius) || (way.end() - way.start()).length() < same_point_mm)
      return keep_tangent(b, way.to - way.from);
    const Point2 center = center_by_radius(way.start(), way.end(), radius.number, *is_ccw);
    const Point2 out = way.end() - center;
    keep_tangent(b, in_space(way.plane, *is_ccw ? Point2{-out.v, out.u} : Point2{out.v, -out.u}));
  }

  static ig::Vec3 in_space(const PlaneAxes& plane, const Point2& p) {
    ig::Vec3 out;
    out[plane.first] = p.u;
    out[plane.second] = p.v;
    return out;
  }
  void keep_tangent(ig::Block& b, const ig::Vec3& direction) const {
    if (const auto tangent = unit(direction)) b.set(tangent_, *tangent);
  }

  ig_field radius_ = center("Parsing.R");
};

const ig::Register<KlartextMotion> klartext_motion_syntax;

}  // namespace
}  // namespace heidenhain
