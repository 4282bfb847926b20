/// Blocks without a move in the plane, under compensation: most rest, G39 turns the corner, and type C starts and ends.
#include "contour/compensated_path.hpp"

namespace iso {

using namespace ig::cnc;

ig::Status CompensatedPath::rest_or_step(ig::Block& b, const ContourMotion& now, double offset) {
  const bool may_step = without_move_ == WithoutMove::at_once && !now.has_event;
  if (!tool_.is_off) return may_step ? start_at_rest(b, now, offset) : ig::Status::unchanged;
  if (b.has(corner_arc_)) return turn_on_arc(b, now, offset);
  if (may_step && offset == 0) return cancel_at_rest(b, now);
  return rest(b, now);
}

ToolSteps::Manner CompensatedPath::manner_of_step(ig::Block& b, double length) const {
  const bool is_rapid = b.is(motion_code_, rapid_code_) || !b.has(motion_code_);
  const double mmds = is_rapid ? 0 : feed_.mmds(b, [&] { return length; });
  return {is_rapid, mmds > 0 ? std::optional(mmds) : std::nullopt, 0};
}

ig::Status CompensatedPath::start_at_rest(ig::Block& b, const ContourMotion& now, double offset) {
  const ContourAhead::Next next = ahead_.next(b, now.plane, rests_allowed_);
  if (next.kind != ContourAhead::Next::Kind::move || next.offset * offset <= 0) return ig::Status::unchanged;
  stand_at(now, now.from, offset);
  step_to(b, now, next.move.offset_start(offset), starting);
  return ig::Status::changed;
}

ig::Status CompensatedPath::cancel_at_rest(ig::Block& b, const ContourMotion& now) {
  step_to(b, now, now.move.end, cancelling);
  tool_ = {};
  return ig::Status::changed;
}

void CompensatedPath::step_to(ig::Block& b, const ContourMotion& now, const Point2& to, Phase phase) {
  turn_corner(b, now, manner_of_step(b, 0));
  const ig::Vec3 end = at(now, to, now.to[now.plane.tool]);
  steps_.line(b, end, manner_of_step(b, iso::length(end - tool_.at)));
  tool_.at = end;
  b.set(phase_, phases_[phase]);
  finish(b);
}

ig::Status CompensatedPath::turn_on_arc(ig::Block& b, const ContourMotion& now, double offset) {
  const Point2 middle = now.move.end, from = ContourMotionOf::in_plane(now.plane, tool_.at);
  Point2 to = from;
  const Point2 way = ContourMotionOf::in_plane(now.plane, b.get(corner_direction_).or_else({}));
  if (way.length() > 0) {
    to = middle + (offset / way.length()) * left_of(way);
  } else if (const auto next = ahead_.next(b, now.plane, rests_allowed_);
             next.kind == ContourAhead::Next::Kind::move && next.offset * offset > 0) {
    to = next.move.offset_start(offset);
  } else {
    b.report(ig::diag("ISO-0478"), ig::Where::block(), std::string_view("no move on this side follows"));
    b.alarm();
    return rest(b, now);
  }
  const bool is_inner = cross(from - middle, to - middle) * offset > 0;
  if (is_inner) {
    b.report(ig::diag("ISO-0479"), ig::Where::block());
    b.alarm();
  }
  const double height = tool_.at[now.plane.tool];
  const ig::Vec3 end = at(now, to, height);
  const ToolSteps::Manner manner = manner_of_step(b, (to - from).length());
  if (!is_same(from, to) && !is_inner)
    steps_.arc(b, end, at(now, middle, height), offset < 0, {false, manner.feed_mmds, 0});
  else if (!is_same(from, to))
    steps_.line(b, end, manner);
  tool_.at = end;
  b.set(phase_, phases_[offsetting]);
  b.set(corner_, corners_[static_cast<std::size_t>(CornerKind::round)]);
  if (is_same(from, to))
    keep_position(b);
  else
    finish(b);
  return ig::Status::changed;
}

ig::Status CompensatedPath::rest(ig::Block& b, const ContourMotion& now) {
  if (now.has_event) {
    ig::Vec3 to = tool_.at;
    to[now.plane.tool] = now.to[now.plane.tool];
    const ToolSteps::Manner manner = take_event(b);
    steps_.line(b, to, manner);
    tool_.at = to;
    finish(b);
    return ig::Status::changed;
  }
  keep_position(b);
  return ig::Status::changed;
}

}  // namespace iso
