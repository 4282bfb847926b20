#include "motion/departure_path.hpp"

#include <isogloss/cnc/program_xyz.hpp>

namespace heidenhain {

using namespace ig::cnc;

bool DeparturePath::follow(ig::Block& b, KlartextWay& way, const KlartextDeparture::Way& words,
                           const ig::PartialVec3& tangent) const {
  using Shape = KlartextDeparture::Shape;
  const Point2 t{tangent.value[way.plane.first], tangent.value[way.plane.second]};
  const bool is_beside = b.is(side_, g41_) || b.is(side_, g42_);
  const bool is_arc = words.shape == Shape::arc || words.shape == Shape::line_and_arc;
  const auto refuse = [&](std::string_view why) {
    b.report(ig::diag("HEI-0130"), ig::Where::block(), std::string_view("DEP"), why);
    return false;
  };
  if (!tangent.complete() || std::fabs(t.length() - 1) > 1e-6) return refuse("no move in the plane came before");
  if (is_arc && b.has(mirror_term_)) return refuse("in a mirror image the tool leaves straight");
  const double left = b.is(side_, g42_) ? -1 : 1,
               radius = is_beside ? b.get_or(tool_radius_, 0.0) / scaling_.factor(b) : 0;
  if (is_arc && !(radius > 0)) return refuse("the tool has no radius, it leaves straight");
  const Point2 n{-t.v * left, t.u * left}, contour = way.start();
  const Point2 from{contour.u + radius * n.u, contour.v + radius * n.v};
  if (words.shape == Shape::line)
    way.set_end({from.u + words.length * t.u, from.v + words.length * t.v});
  else if (words.shape == Shape::normal)
    way.set_end({from.u + words.length * n.u, from.v + words.length * n.v});
  if (is_arc) {
    const double r = words.shape == Shape::arc ? words.radius : std::fabs(words.radius);
    const Point2 center{from.u + r * n.u, from.v + r * n.v};
    const bool is_ccw = (left > 0) == (r > 0);
    Point2 end = ContourApproach::turned(from, center, is_ccw ? words.angle_deg : -words.angle_deg);
    if (words.shape == Shape::line_and_arc) {
      // Seen from its end, the arc turns the other way.
      const auto touching = ContourApproach::touching(way.end(), center, r, !is_ccw);
      if (!touching) return refuse("its end lies inside the arc, the tool leaves straight");
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
  return true;
}

}  // namespace heidenhain
