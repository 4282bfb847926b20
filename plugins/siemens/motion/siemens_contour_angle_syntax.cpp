/// ANG=: a straight line is given by its angle and one coordinate of its end point; the other coordinate is computed.
#include <cmath>
#include <numbers>

#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensContourAngle {
  static constexpr auto spec = ig::syntax("SiemensContourAngleSyntax", "ANG= a straight line by its angle.")
                                   .after("SiemensPositionSyntax", "PlaneSelectSyntax")
                                   .before("SiemensArcSyntax", "SiemensCycleSyntax", "ProgramXyzSyntax");

  ig::Word angle_{"Parsing.ANG", ig::wake, "deg", "Against the first axis of the plane."};
  ig::Codes straight_{{"G00", "G01"}, ig::read};
  ig::Codes arcs_{{"G02", "G03", "CIP"}, ig::read};
  ig::In<ig::Symbol> motion_{"MotionState.Term"};
  ig::Xyz words_{"Parsing", ig::read | ig::write};
  PlaneInForce plane_;
  LastProgramXyz last_;
  ig::Name g02_{"G02"}, g03_{"G03"};

  ig::Status build(ig::Block& b) {
    const auto angle = b.take(angle_);
    if (!angle) return ig::Status::unchanged;
    const PlaneAxes plane = plane_(b);
    const ig::PartialVec3 named = b.get(words_);
    const ig::Vec3 from = last_(b);
    const double turn = std::fmod(*angle, 360) * radians_per_degree, along = std::cos(turn), across = std::sin(turn);
    const bool by_first = named.has(plane.first), by_second = named.has(plane.second);
    const double slope = by_first ? along : across;
    // Both coordinates, or none, belong to contours of several lines, which the control computes from their blocks
    // together.
    if (by_first == by_second || std::fabs(slope) < 1e-9 || is_arc(b)) {
      b.report(ig::diag("SIE-0262"), ig::Where::word(angle_.id()),
               "ANG=: the end point of the contour line is not computed");
      return ig::Status::changed;
    }
    const std::size_t given = by_first ? plane.first : plane.second, other = by_first ? plane.second : plane.first;
    const double way = (named.value[given] - from[given]) / slope;
    b.set(words_.id(other), rounded(from[other] + way * (by_first ? across : along)));
    return ig::Status::changed;
  }

 private:
  bool is_arc(const ig::Block& b) const {
    if (b.find(arcs_)) return true;
    return !b.find(straight_) && (b.is(motion_, g02_) || b.is(motion_, g03_));
  }
};

const ig::Register<SiemensContourAngle> siemens_contour_angle_syntax;

}  // namespace
}  // namespace siemens
