// The way of a cycle from hole to hole.
#include "cycles/hole_cycle.hpp"

namespace heidenhain {

using namespace ig::cnc;

bool HoleCycle::go_to(ig::Block& b, Call& call, std::int64_t i) const {
  if (i >= (call.points.is_pattern ? call.points.count : 1)) return false;
  HoleRun& c = call.hole;
  if (!call.points.is_pattern)
    position(b, call);
  else if (call.points.list != nullptr)
    go_along_list(b, call, i);
  else
    go_along_pattern(b, call, i);
  rapid_to(b, c, c.safe);
  return true;
}

void HoleCycle::position(ig::Block& b, Call& call) const {
  HoleRun& c = call.hole;
  const std::size_t tool = c.plane.tool;
  c.level = c.hole[tool];
  if (call.named.mask == 0) return;
  ig::Vec3 to = call.named.or_else(c.hole);
  const auto code = b.find(motions_);
  const double feed = code && *code == 0 ? 0 : feed_of_way(b);
  if (b.has(at_position_)) {
    const bool is_below = (c.safe - c.level) * (c.safe - c.bottom) > 0;
    if (is_below) feed_to(b, c, c.safe, feed);
    to[tool] = c.level;
  }
  c.hole = to;
  if (feed > 0 || !(code && *code == 0))
    motion.feed_to(b, to, feed);
  else
    motion.rapid_to(b, to);
}

double HoleCycle::feed_of_way(ig::Block& b) const {
  const auto own = b.get(way_feed_);
  const double mmds =
      own ? *own * (b.get_or(way_per_revolution_, false) ? speed(b) : 1) / 60 : in_mmds(b, b.get_or(feed_, 0.0));
  if (!(mmds > 0)) in_force_.report_missing(b);
  return mmds;
}

void HoleCycle::go_along_pattern(ig::Block& b, Call& call, std::int64_t i) const {
  HoleRun& c = call.hole;
  if (i == 0) {
    call.end = c.end;
    rapid_to(b, c, call.end);
  }
  c.hole = pattern_.point(b, call.points, c.plane, c.hole, i);
  motion.rapid_to(b, c.at(c.level));
  c.end = call.points.is_high || i + 1 == call.points.count ? call.end : c.safe;
}

void HoleCycle::go_along_list(ig::Block& b, Call& call, std::int64_t i) const {
  HoleRun& c = call.hole;
  if (i == 0) {
    call.at_call = c.level = c.hole[c.plane.tool];
    call.end = c.end;
    const auto code = b.find(motions_);
    if (!code || *code != 0) call.feed_mmds = feed_of_way(b);
  }
  const PatternPoint& point = (*call.points.list)[static_cast<std::size_t>(i)];
  const double more = point.surface - call.added;
  call.added += more;
  for (double* const level : {&c.surface, &c.safe, &c.bottom, &call.end}) *level += more;
  // fmax and fmin pass over a clearance of NaN.
  const auto higher = [&](double x, double y) { return c.out() > 0 ? std::fmax(x, y) : std::fmin(x, y); };
  const double high = higher(higher(call.at_call, call.end), point.clearance);
  const double way = higher(high, call.clearance_before);
  call.clearance_before = point.clearance;
  if (c.level != way) rapid_to(b, c, way);
  c.hole = pattern_.point(b, call.points, c.plane, c.hole, i);
  if (call.feed_mmds)
    motion.feed_to(b, c.at(way), *call.feed_mmds);
  else
    motion.rapid_to(b, c.at(way));
  c.level = way;
  c.end = high;
}

}  // namespace heidenhain
