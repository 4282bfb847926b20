#include "motion/polar_coordinates.hpp"

#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/cnc/units.hpp>

namespace heidenhain {

using namespace ig::cnc;

bool PolarCoordinates::is_known(ig::Block& b, const KlartextWay& way) const {
  if (b.get(pole_).complete()) return true;
  b.report(ig::diag("HEI-0132"), ig::Where::block(), b.text(way.function));
  return false;
}

bool PolarCoordinates::resolve(ig::Block& b, KlartextWay& way) const {
  ig_value v[4];
  const std::uint32_t has = b.take_many(words_.data(), 4, v);
  if (!is_known(b, way)) return false;
  if (has == 0 && way.function != cp_) return true;
  const Point2 center = pole(b, way), out = way.start() - center;
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

void PolarCoordinates::note_circles(ig::Block& b, const KlartextWay& way, const Point2& center, double turned) const {
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

}  // namespace heidenhain
