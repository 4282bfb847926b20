// The meaning of the words of a path block: increments become positions, polar coordinates become rectangular ones, the
// pole CC becomes the centre of an arc, and CT finds its own centre. From here on the block is one of G00 to G03, as in
// the other languages.
#include <isogloss/cnc/arc.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>
#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/sdk.hpp>

#include "motion/departure_path.hpp"
#include "motion/klartext_way.hpp"
#include "motion/polar_coordinates.hpp"
#include "motion/tool_axis_retract.hpp"

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
      ig::diagnostic(IG_ERROR, "HEI-0193",
                     "{0} is no circle in the machine: the scaling acts on one axis of its plane and not on the other"),
  };

  ig::In<ig::Symbol> function_{"KlartextPath.Function", ig::wake};
  ig::In<bool> is_ccw_{"KlartextPath.IsCcw"};
  ig::Xyz words_{"Parsing", ig::read | ig::write | ig::take};
  std::array<ig_field, 3> steps_{step("IX", "mm"), step("IY", "mm"), step("IZ", "mm")};
  PolarCoordinates polar_;
  std::array<ig_field, 3> rotary_{rotary("Parsing.A"), rotary("Parsing.B"), rotary("Parsing.C")};
  std::array<ig_field, 3> centers_{center("Parsing.I"), center("Parsing.J"), center("Parsing.K")};
  ig::Codes motions_{{"G00", "G01", "G02", "G03"}, ig::read | ig::write};
  ig::Xyz tangent_{"KlartextPath.Tangent",
                   ig::read | ig::write,
                   {ig::Life::modal, "", "Where the path before goes on to: a unit vector."}};
  PlaneInForce plane_;
  LastProgramXyz last_;
  ig::Xyz machine_{"MachineCoordinate", ig::read};
  ig::Codes of_machine_{{"G53"}, ig::read};
  ToolAxisRetract retract_;
  DeparturePath departure_;
  ScalingInForce scaling_;
  ScaleAndMirror mirror_;
  ig::In<ig::Symbol> mirror_term_{"MirrorImage.Term"};
  ig::Out<bool> in_plane_{"KlartextPath.IsFeedInPlane", {ig::Life::block, "", "The move may end in a corner."}};
  ig::Signal open_{"KlartextCorner.~Open", ig::read | ig::write, ig::Life::modal};
  /// Without these a straight line goes to its words.
  ig::AnyOf more_than_words_{steps_[0],           steps_[1],          steps_[2],        retract_.to_limit(),
                             retract_.distance(), departure_.shape(), mirror_term_.id()};
  ig::AnyOf rotary_words_{rotary_[0], rotary_[1], rotary_[2]};
  ig::Name l_{"L"}, ln_{"LN"}, lp_{"LP"}, c_{"C"}, cc_{"CC"}, cr_{"CR"}, ct_{"CT"}, cp_{"CP"}, ctp_{"CTP"}, rnd_{"RND"};

  ig::Status build(ig::Block& b) {
    const auto function = b.get(function_);
    if (!function || *function == cc_) return ig::Status::unchanged;
    const ig::PartialVec3 named = b.get(words_);
    const bool is_plain = (*function == l_ || *function == ln_) && named.mask != 0 && !b.has_any(more_than_words_);
    if (!is_plain) return resolve(b, *function, named);
    const ig::Vec3 from = last_(b), to = named.or_else(from);
    note_corner(b, plane_.tool_axis(b), from, to);
    keep_tangent(b, to - from);
    return ig::Status::changed;
  }

 private:
  [[gnu::noinline]] ig::Status resolve(ig::Block& b, ig::Symbol function, const ig::PartialVec3& named) const {
    ig_value steps[3];
    const std::uint32_t has_steps =
        b.has_any(steps_[0], steps_[1], steps_[2]) ? b.take_many(steps_.data(), 3, steps) : 0;

    KlartextWay way{plane_(b), start(b), {}, named.mask | has_steps, function};
    way.to = named.or_else(way.from);
    if (has_steps != 0) {
      const ig::Vec3 base = b.find(of_machine_) ? b.get(machine_).or_else(way.from) : way.from;
      for (std::size_t axis = 0; axis < 3; ++axis)
        if ((has_steps >> axis & 1u) != 0) way.to[axis] = base[axis] + steps[axis].number;
    }
    const bool is_polar = function == lp_ || function == cp_ || function == ctp_;
    if (is_polar) refuse_in_plane(b, way, named.mask, has_steps, b.text(function));
    if (is_polar && !polar_.resolve(b, way)) return drop(b);
    if (retract_.is_programmed(b) && retract_.follow(b, way, last_(b))) put(b, way);
    if (const auto words = departure_.words(b); words && departure_.follow(b, way, *words, b.get(tangent_))) {
      if (words->shape != KlartextDeparture::Shape::line_and_arc && !is_polar)
        report_in_plane(b, way, named.mask, has_steps, "DEP");
      put(b, way);
    }
    const bool is_computed = is_polar || has_steps != 0 || named.mask == 0 || function == c_ || function == ct_;
    if (is_computed && !(is_position(way.from) && is_position(way.to))) {
      b.report(ig::diag("HEI-0182"), ig::Where::block(), b.text(function));
      return drop(b);
    }
    if (way.mask == 0 && function != c_) return ig::Status::changed;
    if (is_polar || has_steps != 0 || function == c_) put(b, way);
    note_corner(b, way.plane.tool, way.from, way.to);
    if (is_arc(function) && !scaling_.keeps_circles(b, way.plane))
      b.report(ig::diag("HEI-0193"), ig::Where::block(), b.text(function));

    if (function == c_ || function == cp_) return about_pole(b, way);
    if (function == ct_ || function == ctp_)
      along_tangent(b, way);
    else if (function == cr_)
      keep_tangent_of_radius(b, way);
    else
      keep_tangent(b, way.to - way.from);
    return ig::Status::changed;
  }

  bool is_arc(ig::Symbol function) const {
    return function == c_ || function == cp_ || function == cr_ || function == ct_ || function == ctp_;
  }

  /// Reports X and Y where the block gets its point in the plane from other words.
  void report_in_plane(ig::Block& b, const KlartextWay& way, std::uint32_t named, std::uint32_t has_steps,
                       std::string_view of) const {
    for (const std::size_t axis : {way.plane.first, way.plane.second})
      if (((named | has_steps) >> axis & 1u) != 0) {
        const bool is_step = (has_steps >> axis & 1u) != 0;
        const std::string word = std::string(is_step ? "I" : "") + "XYZ"[axis];
        b.report(ig::diag("HEI-0103"), ig::Where::word(is_step ? steps_[axis] : words_.id(axis)),
                 std::string_view(word), of);
      }
  }
  /// The same for a polar function, and takes the words out of the block and of its way.
  void refuse_in_plane(ig::Block& b, KlartextWay& way, std::uint32_t named, std::uint32_t has_steps,
                       std::string_view of) const {
    report_in_plane(b, way, named, has_steps, of);
    for (const std::size_t axis : {way.plane.first, way.plane.second})
      if ((way.mask >> axis & 1u) != 0) {
        b.erase(words_.id(axis));
        way.to[axis] = way.from[axis];
        way.mask &= ~(1u << axis);
      }
  }

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

  /// After a feed move in the plane without rotary axes KlartextCornerSyntax looks for RND and CHF.
  void note_corner(ig::Block& b, std::size_t tool_axis, const ig::Vec3& from, const ig::Vec3& to) const {
    if (from[tool_axis] == to[tool_axis] && can_end_in_corner(b)) {
      b.set(in_plane_, true);
      b.raise(open_);
    } else if (b.is_raised(open_)) {
      b.erase(open_);
    }
  }
  bool can_end_in_corner(const ig::Block& b) const {
    const auto code = b.find(motions_);
    return code && *code != 0 && !b.has_any(rotary_words_);
  }

  /// Writes positions into the block; an axis that it does not move gets no word.
  void put(ig::Block& b, const KlartextWay& way) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((way.mask >> axis & 1u) != 0) b.set(words_.id(axis), rounded(way.to[axis]));
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

  // ---- arcs

  ig::Status about_pole(ig::Block& b, const KlartextWay& way) const {
    const auto is_ccw = b.get(is_ccw_);
    if (!polar_.is_known(b, way)) return drop(b);
    if (!is_position(polar_.pole(b))) {
      b.report(ig::diag("HEI-0182"), ig::Where::block(), b.text(way.function));
      return drop(b);
    }
    if (is_ccw) arc(b, way, polar_.pole(b, way), *is_ccw);
    return ig::Status::changed;
  }

  void arc(ig::Block& b, const KlartextWay& way, const Point2& center, bool is_ccw) const {
    const Point2 from = way.start();
    b.set(centers_[way.plane.first], center.u - from.u);
    b.set(centers_[way.plane.second], center.v - from.v);
    const Point2 out = way.end() - center;
    keep_tangent(b, in_space(way.plane, is_ccw ? Point2{-out.v, out.u} : Point2{out.v, -out.u}));
  }

  void raise(ig::Block& b, std::size_t motion) const { b.raise(motions_.id(motion)); }

  /// CT: the arc that continues the direction of the path before and ends at the point.
  void along_tangent(ig::Block& b, const KlartextWay& way) const {
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

  void keep_tangent_of_radius(ig::Block& b, const KlartextWay& way) const {
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
