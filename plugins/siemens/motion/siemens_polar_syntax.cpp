/// G110, G111 and G112 set the pole; AP= and RP= are angle and radius from it. The words become positions in the plane,
/// in place, so that no later syntax has to know of polar coordinates. An arc without a centre of its own turns about
/// the pole.
#include <cmath>
#include <numbers>

#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

#include "modes/axis_modes.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensPolar {
  static constexpr auto spec =
      ig::syntax("SiemensPolarSyntax", "G110/G111/G112 pole, AP= and RP= polar positions.")
          .after("SiemensUnitSyntax", "PlaneSelectSyntax", "PositioningModeSyntax", "SiemensCoordinateOffsetSyntax")
          .before("SiemensMachineCoordinatesSyntax", "SiemensPositionSyntax", "SiemensArcSyntax", "ProgramXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0274", "{0} has a word that a pole does not take: the word is ignored"),
      ig::diagnostic(IG_WARNING, "SIE-0294", "{0} has {1} without {2}, which is assumed to be 0: program both"),
      ig::diagnostic(IG_ERROR, "SIE-0278",
                     "the position is not computed, because the polar radius is {0}: program RP= of 0 or more"),
      ig::diagnostic(IG_ERROR, "SIE-0279",
                     "AP= or RP= stands beside an axis of the plane: only the polar position is used"),
  };

  ig::Call poles_{{"G110", "G111", "G112"}, "X Y Z"};
  ig::Word ap_{"Parsing.AP", ig::wake, "deg", "Polar angle."}, rp_{"Parsing.RP", ig::wake, "mm", "Polar radius."};
  ig::Xyz words_{"Parsing", ig::read | ig::write};
  std::array<ig::Word, 3> centre_{ig::Word{"Parsing.I", ig::read | ig::write},
                                  ig::Word{"Parsing.J", ig::read | ig::write},
                                  ig::Word{"Parsing.K", ig::read | ig::write}};
  std::array<ig::Word, 3> other_centres_{ig::Word{"Parsing.CR", ig::read, "mm"},
                                         ig::Word{"Parsing.AR", ig::read, "deg"},
                                         ig::Word{"Parsing.I1", ig::read, "mm"}};
  AxisModes modes_{ig::read | ig::write};
  ig::Xyz pole_{"PolarCoordinate.Pole", ig::read | ig::write};
  ig::Out<double> radius_{"PolarCoordinate.Radius"}, angle_{"PolarCoordinate.Angle_deg"};
  ig::Codes motions_{{"G00", "G01", "G02", "G03"}, ig::read};
  ig::In<ig::Symbol> motion_{"MotionState.Term"};
  ig::Name g02_{"G02"}, g03_{"G03"}, ac_{"AC"}, ic_{"IC"};
  PlaneInForce plane_;
  DistanceMode distance_;
  LastProgramXyz last_;

  ig::Status build(ig::Block& b) {
    const auto pole = b.take(poles_);
    const auto ap = b.take(ap_), rp = b.take(rp_);
    if (pole)
      put_pole(b, *pole, ap, rp);
    else if (ap || rp)
      resolve(b, ap, rp);
    return ig::Status::changed;
  }

 private:
  ig::Vec3 pole(const ig::Block& b) const { return b.get(pole_).or_else({}); }

  /// Sets the pole at a distance in the plane, given by coordinates or by angle and radius.
  void put_pole(ig::Block& b, const ig::Words& words, std::optional<double> ap, std::optional<double> rp) const {
    const PlaneAxes plane = plane_(b);
    ig::Vec3 at = words.row == 0 ? last_(b) : words.row == 2 ? pole(b) : ig::Vec3{};
    at[plane.tool] = 0;
    if (ap.has_value() != rp.has_value())
      b.report(ig::diag("SIE-0294"), ig::Where::word(ap ? ap_.id() : rp_.id()), b.text(words.code),
               std::string_view(ap ? "AP=" : "RP="), std::string_view(ap ? "RP=" : "AP="));
    if (ap || rp) {
      at[plane.first] += rp.value_or(0) * std::cos(ap.value_or(0) * radians_per_degree);
      at[plane.second] += rp.value_or(0) * std::sin(ap.value_or(0) * radians_per_degree);
    } else {
      for (const std::size_t axis : {plane.first, plane.second}) at[axis] += words["XYZ"[axis]].value_or(0);
    }
    if (words["XYZ"[plane.tool]] || ((ap || rp) && words.mask != 0))
      b.report(ig::diag("SIE-0274"), ig::Where::word(poles_.code(words.row)), b.text(words.code));
    if (!is_sound(at)) {
      b.report(ig::diag("SIE-0105"), ig::Where::word(poles_.code(words.row)), b.text(words.code));
      return;
    }
    b.set(pole_, rounded(at));
    b.erase(radius_);
    b.erase(angle_);
  }
  static bool is_sound(const ig::Vec3& p) {
    return std::fabs(p.x) < 1e9 && std::fabs(p.y) < 1e9 && std::fabs(p.z) < 1e9;
  }

  void resolve(ig::Block& b, std::optional<double> ap, std::optional<double> rp) const {
    const auto where = ig::Where::word(ap ? ap_.id() : rp_.id());
    const PlaneAxes plane = plane_(b);
    const ig::Vec3 from = last_(b), centre = pole(b);
    const double u = from[plane.first] - centre[plane.first], v = from[plane.second] - centre[plane.second];
    const double present_radius = b.get_or(radius_, std::hypot(u, v));
    const double present_angle = b.get_or(angle_, std::atan2(v, u) / radians_per_degree);
    const double radius = rp ? *rp + (is_increment(b, AxisModes::rp, false) ? present_radius : 0) : present_radius;
    const double angle =
        ap ? *ap + (is_increment(b, AxisModes::ap, distance_.is_incremental(b)) ? present_angle : 0) : present_angle;
    ig::Vec3 to = centre;
    to[plane.first] += radius * std::cos(angle * radians_per_degree);
    to[plane.second] += radius * std::sin(angle * radians_per_degree);
    if (radius < 0 || !is_sound(to)) {
      b.report(ig::diag("SIE-0278"), where, radius);
      return;
    }
    to = rounded(to);
    const ig::PartialVec3 named = b.get(words_);
    if (named.has(plane.first) || named.has(plane.second)) b.report(ig::diag("SIE-0279"), where);
    for (const std::size_t axis : {plane.first, plane.second}) {
      b.set(words_.id(axis), to[axis]);
      modes_.set(b, axis, ac_);
    }
    b.set(radius_, radius);
    b.set(angle_, angle);
    if (is_arc(b) && !has_centre(b)) {
      b.set(centre_[plane.first], rounded(-u));
      b.set(centre_[plane.second], rounded(-v));
    }
  }

  bool is_increment(const ig::Block& b, std::size_t word, bool otherwise) const {
    const auto mode = modes_.get(b, word);
    return mode ? *mode == ic_ : otherwise;
  }
  bool is_arc(const ig::Block& b) const {
    if (const auto code = b.find(motions_)) return *code > 1;
    return b.is(motion_, g02_) || b.is(motion_, g03_);
  }
  bool has_centre(const ig::Block& b) const {
    for (const auto* list : {&centre_, &other_centres_})
      for (const ig::Word& word : *list)
        if (b.has(word)) return true;
    return false;
  }
};

const ig::Register<SiemensPolar> siemens_polar_syntax;

}  // namespace
}  // namespace siemens
