/// How compensation starts and ends: the move onto the contour, the move off it, and the blocks that suspend it.
#include "contour/compensated_path.hpp"

namespace iso {

using namespace ig::cnc;

ig::Status CompensatedPath::start(ig::Block& b, const ContourMotion& now, double offset) {
  if (now.move.is_arc) {
    b.report(ig::diag("ISO-0465"), ig::Where::block(), std::string_view("start"));
    b.alarm();
    return ig::Status::unchanged;
  }
  const ContourAhead::Next next = following(b, now, offset);
  Corner corner = square_corner(now.move, offset);
  if (next.kind == ContourAhead::Next::Kind::move && next.offset * offset > 0) {
    const Corner round = corner_to(b, now, next, offset);
    const bool is_outer =
        round.kind == CornerKind::obtuse || round.kind == CornerKind::acute || round.kind == CornerKind::round;
    if (const auto way = ahead_.starts_behind(b, now.move, next.move, offset))
      corner = about_first_or_last(b, *way, next.move, offset);
    else if (is_type_b_ && is_outer)
      corner = round;
    else
      corner.leave = next.move.offset_start(offset);
  }
  report_too_far(b, next);
  stand_at(now, now.from, offset);
  const auto way = approach_.get(b);
  const ig::Status status = way && next.kind == ContourAhead::Next::Kind::move
                                ? approach(b, now, *way, next.move.direction_at_start(), corner, offset)
                                : move(b, now, starting, corner, offset);
  tool_.is_blind = next.kind == ContourAhead::Next::Kind::none;
  return status;
}

ig::Status CompensatedPath::approach(ig::Block& b, const ContourMotion& now, const ContourApproach::Way& way,
                                     const Point2& along, const Corner& corner, double offset) {
  const Point2 side = (offset > 0 ? 1.0 : -1.0) * left_of(along);
  const auto path =
      ContourApproach::path(way, ContourMotionOf::in_plane(now.plane, now.from), corner.leave, along, side);
  if (!path || !is_sound(corner)) {
    b.report(ig::diag("ISO-0497"), ig::Where::block());
    b.alarm();
    return move(b, now, starting, corner, offset);
  }
  const ToolSteps::Manner manner = take_event(b);
  const double height = now.to[now.plane.tool];
  const ig::Vec3 to = at(now, corner.leave, height);
  const ToolSteps::Manner first{way.is_rapid, way.feed_mmds ? way.feed_mmds : manner.feed_mmds, 0};
  const double before = now.from[now.plane.tool];
  steps_.line(b, at(now, path->begin, before), first);
  if (height != before) steps_.line(b, at(now, path->begin, height), first);
  if (path->center && !is_same(path->begin, corner.leave))
    steps_.arc(b, to, at(now, *path->center, height), path->is_ccw, manner);
  else
    steps_.line(b, to, manner);
  return arrive(b, now, starting, corner, offset, to);
}

ig::Status CompensatedPath::cancel(ig::Block& b, const ContourMotion& now) {
  if (now.move.is_arc) {
    b.report(ig::diag("ISO-0465"), ig::Where::block(), std::string_view("end"));
    b.alarm();
    return go_on(b, now, tool_.offset);
  }
  if (const auto arc = departure_.get(b)) return depart(b, now, *arc);
  Corner corner;
  corner.leave = now.move.end;
  const ig::Status status = move(b, now, cancelling, corner, 0);
  tool_ = {};
  return status;
}

ig::Status CompensatedPath::depart(ig::Block& b, const ContourMotion& now, const ContourDeparture::Arc& arc) {
  const ToolSteps::Manner manner = take_event(b);
  turn_corner(b, now, manner);
  const double height = tool_.at[now.plane.tool];
  const Point2 center = ContourMotionOf::in_plane(now.plane, arc.center);
  const Point2 end = ContourMotionOf::in_plane(now.plane, arc.end);
  steps_.arc(b, at(now, end, height), at(now, center, height), arc.is_ccw, manner);
  tool_.at = at(now, end, height);
  if (!is_same(end, now.move.end)) steps_.line(b, at(now, now.move.end, height), manner);
  if (now.to[now.plane.tool] != height) steps_.line(b, now.to, manner);
  tool_.at = now.to;
  b.set(phase_, phases_[cancelling]);
  finish(b);
  tool_ = {};
  return ig::Status::changed;
}

ig::Status CompensatedPath::suspend(ig::Block& b, const ContourMotion& now) {
  if (now.turns) {
    b.report(ig::diag("ISO-0472"), ig::Where::block());
    b.alarm();
  } else if (tool_.is_off) {
    b.report(ig::diag("ISO-0470"), ig::Where::block(),
             b.has(compound_) ? b.text(b.get_or(compound_, ig::Symbol{})) : std::string_view("G53"));
  }
  tool_ = {};
  return ig::Status::unchanged;
}

void CompensatedPath::report_too_far(ig::Block& b, const ContourAhead::Next& next) const {
  if (next.kind == ContourAhead::Next::Kind::too_far)
    b.report(ig::diag("ISO-0469"), ig::Where::block(), static_cast<double>(rests_allowed_));
}

}  // namespace iso
