/// The tool beside the contour: each move, the corner at its end, and what the block writes.
#include "contour/compensated_path.hpp"

namespace iso {

using namespace ig::cnc;

ig::Status CompensatedPath::build(ig::Block& b) {
  const ContourMotion now = motion_(b);
  const BrokenContour::Piece piece = contour_.take(b, now);
  programmed_ = now.to;
  manner_.reset();
  inserted_.reset();
  next_start_.reset();
  const double offset = ahead_.offset_in_force(b);
  find_tool(b, now);
  if (!tool_.is_off && offset == 0) return ig::Status::unchanged;
  if (tool_.is_off && !(tool_.plane == now.plane)) {
    b.report(ig::diag("ISO-0471"), ig::Where::block());
    b.alarm();
    tool_ = {};
  }
  const bool may_end = end_off_ == EndOff::allowed && offset == 0;
  if (tool_.is_off && b.has(program_end_) && !may_end) b.report(ig::diag("ISO-0473"), ig::Where::block());
  switch (now.kind) {
    case ContourMotion::Kind::by_steps: return suspend(b, now);
    case ContourMotion::Kind::rest: return rest_or_step(b, now, offset);
    case ContourMotion::Kind::move: break;
  }
  if (piece.corner) {
    inserted_ = piece.corner->move;
    next_start_ = piece.corner->move.end;
  }
  const ig::Status status = follow(b, piece.motion, offset);
  if (!manner_) return status;
  contour_.report(b, piece);
  inserted_.reset();
  if (piece.corner && piece.corner_feed_mmds) manner_->feed_mmds = piece.corner_feed_mmds;
  if (piece.corner) go_round_corner(b, *piece.corner, offset);
  return status;
}

ig::Status CompensatedPath::follow(ig::Block& b, const ContourMotion& now, double offset) {
  if (offset == 0) return cancel(b, now);
  return tool_.is_off ? go_on(b, now, offset) : start(b, now, offset);
}

void CompensatedPath::go_round_corner(ig::Block& b, const ContourMotion& corner, double offset) {
  if (tool_.is_off) {
    go_on(b, corner, offset != 0 ? offset : tool_.offset);
    return;
  }
  const ToolSteps::Manner manner{false, manner_->feed_mmds, 0};
  if (corner.move.is_arc)
    steps_.arc(b, corner.to, at(corner, corner.move.center, corner.to[corner.plane.tool]), corner.move.is_ccw, manner);
  else
    steps_.line(b, corner.to, manner);
  tool_.at = corner.to;
  finish(b);
  tool_ = {};
}

ContourAhead::Next CompensatedPath::following(ig::Block& b, const ContourMotion& now, double offset) const {
  ContourAhead::Next next;
  if (inserted_) {
    next.kind = ContourAhead::Next::Kind::move;
    next.offset = offset;
    next.move = *inserted_;
    return next;
  }
  next = ahead_.next(b, now.plane, rests_allowed_);
  if (next_start_ && next.kind == ContourAhead::Next::Kind::move)
    next.move = between_corners(next.move, *next_start_, next.move.end);
  return next;
}

void CompensatedPath::find_tool(ig::Block& b, const ContourMotion& now) {
  if (!tool_.is_off) {
    const ig::PartialVec3 carried = b.get(vector_);
    if (!carried.complete() || carried.value == ig::Vec3{}) return;
    stand_at(now, now.from + carried.value, ahead_.offset_in_force(b));
  } else if (b.frame_changed()) {
    const auto here = [&](const ig::Vec3& machine) { return rounded(b.to_program(machine).value_or(machine)); };
    tool_.at = here(tool_.machine);
    tool_.corner_center = ContourMotionOf::in_plane(now.plane, here(tool_.center_machine));
    for (std::size_t i = 0; i < tool_.corner.count; ++i)
      tool_.corner.steps[i].to = ContourMotionOf::in_plane(now.plane, here(tool_.steps_machine[i]));
  }
}

void CompensatedPath::stand_at(const ContourMotion& now, const ig::Vec3& at, double offset) {
  tool_ = {};
  tool_.is_off = true;
  tool_.plane = now.plane;
  tool_.at = at;
  tool_.offset = offset;
}

Corner CompensatedPath::corner_to(ig::Block& b, const ContourMotion& now, const ContourAhead::Next& next,
                                  double offset) const {
  if (const auto limit = b.get(corner_limit_))
    if (const auto crossing = outer_crossing(now.move, next.move, offset, *limit)) return *crossing;
  // A rapid makes no arc.
  return iso::corner(now.move, next.move, offset, next.is_rapid ? OuterCorner::lines : OuterCorner{outer_corner_});
}

Corner CompensatedPath::about_first_or_last(ig::Block& b, const ContourMove& before, const ContourMove& after,
                                            double offset) const {
  if (const auto limit = b.get(corner_limit_))
    if (const auto crossing = outer_crossing(before, after, offset, *limit)) return *crossing;
  return arc_about_corner(before, after, offset);
}

ig::Status CompensatedPath::go_on(ig::Block& b, const ContourMotion& now, double offset) {
  if (tool_.left_out > 0) return leave_out(b, now, offset);
  const Point2 from = ContourMotionOf::in_plane(now.plane, tool_.at);
  if (tool_.is_blind && !is_same(from, now.move.offset_start(offset)))
    b.report(ig::diag("ISO-0475"), ig::Where::block());
  const ContourAhead::Next next = following(b, now, offset);
  const Corner corner = end_of(b, now, offset, next);
  report_too_far(b, next);
  if (may_be_narrow(now, next, corner)) report_neck(b, now, offset, corner);
  const ig::Status status = move(b, now, offsetting, corner, offset);
  tool_.is_blind = next.kind == ContourAhead::Next::Kind::none;
  return status;
}

Corner CompensatedPath::end_of(ig::Block& b, const ContourMotion& now, double offset, const ContourAhead::Next& next) {
  if (next.kind != ContourAhead::Next::Kind::move || !now.move.fits(offset)) return square_corner(now.move, offset);
  if (next.offset == 0) {
    if (next.direction.length() > 0) return directed_end(now.move, offset, next.direction);
    if (const auto away = ContourAhead::leaves_behind(now.move, next, offset))
      return about_first_or_last(b, now.move, *away, offset);
    const bool goes_at_once = without_move_ == WithoutMove::at_once && next.cancels_at_rest;
    if (!is_type_b_ || next.move.is_arc || goes_at_once) return square_corner(now.move, offset);
    const Corner round = corner_to(b, now, next, offset);
    return round.kind == CornerKind::inner ? square_corner(now.move, offset) : round;
  }
  if (next.offset * offset < 0) return change_of_side(now.move, offset, next.move, next.offset);
  const Corner corner = corner_to(b, now, next, offset);
  if (interference_ != Interference::ignore)
    if (const auto around = go_around(b, now, offset, next, corner)) return *around;
  if (!next.move.fits(offset)) return square_corner(now.move, offset);
  if (corner.kind == CornerKind::no_solution) {
    b.report(ig::diag("ISO-0468"), ig::Where::block());
    b.alarm();
  }
  return corner;
}

ig::Status CompensatedPath::move(ig::Block& b, const ContourMotion& now, Phase phase, const Corner& corner,
                                 double offset) {
  if (!is_sound(corner)) {
    b.report(ig::diag("ISO-0474"), ig::Where::block());
    tool_ = {};
    return ig::Status::unchanged;
  }
  const ToolSteps::Manner manner = take_event(b);
  turn_corner(b, now, manner);
  const Point2 from = ContourMotionOf::in_plane(now.plane, tool_.at);
  const double height = now.to[now.plane.tool];
  const ig::Vec3 to = at(now, corner.leave, height);
  if (goes_along_arc(b, now, phase, from, corner.leave, offset))
    steps_.arc(b, to, at(now, now.move.center, tool_.at[now.plane.tool]), now.move.is_ccw,
               on_arc(b, now, manner, offset));
  else
    steps_.line(b, to, manner);
  return arrive(b, now, phase, corner, offset, to);
}

ig::Status CompensatedPath::arrive(ig::Block& b, const ContourMotion& now, Phase phase, const Corner& corner,
                                   double offset, const ig::Vec3& to) {
  tool_.at = to;
  tool_.offset = offset;
  tool_.corner_center = now.move.end;
  tool_.corner = corner;
  keep_corner(b, now, to[now.plane.tool]);
  b.set(phase_, phases_[phase]);
  if (phase != cancelling) b.set(corner_, corners_[static_cast<std::size_t>(corner.kind)]);
  finish(b);
  return ig::Status::changed;
}

void CompensatedPath::keep_corner(ig::Block& b, const ContourMotion& now, double height) {
  tool_.center_machine = b.to_machine(now.to).value_or(now.to);
  for (std::size_t i = 0; i < tool_.corner.count; ++i) {
    const ig::Vec3 step = at(now, tool_.corner.steps[i].to, height);
    tool_.steps_machine[i] = b.to_machine(step).value_or(step);
  }
}

void CompensatedPath::turn_corner(ig::Block& b, const ContourMotion& now, const ToolSteps::Manner& manner) {
  const double height = tool_.at[now.plane.tool];
  for (std::size_t i = 0; i < tool_.corner.count; ++i) {
    const Corner::Step& step = tool_.corner.steps[i];
    const ig::Vec3 to = at(now, step.to, height);
    if (step.is_arc)
      steps_.arc(b, to, at(now, tool_.corner_center, height), step.is_ccw, {manner.is_rapid, manner.feed_mmds, 0});
    else
      steps_.line(b, to, manner);
    tool_.at = to;
  }
  tool_.corner.count = 0;
}

CompensatedPath::FeedOnArcs CompensatedPath::feed_on_arcs(const ig::Block& b) const {
  for (std::size_t i = 0; i < feeds_at_.size(); ++i)
    if (b.is(feed_at_, feeds_at_[i])) return static_cast<FeedOnArcs>(i);
  return feed_on_arcs_;
}

ToolSteps::Manner CompensatedPath::on_arc(const ig::Block& b, const ContourMotion& now, const ToolSteps::Manner& manner,
                                          double offset) const {
  const FeedOnArcs at = feed_on_arcs(b);
  const double contour = (now.move.end - now.move.center).length();
  const double path = now.move.path_radius(now.move.end, offset);
  if (!manner.feed_mmds || at == FeedOnArcs::center || (path > contour && at == FeedOnArcs::contour_inside))
    return manner;
  ToolSteps::Manner out = manner;
  out.feed_mmds = *manner.feed_mmds * path / contour;
  return out;
}

void CompensatedPath::report_narrow_arc(ig::Block& b, const ContourMotion& now, double offset) const {
  const double mm = ahead_.scale(b);
  b.report(ig::diag("ISO-0466"), ig::Where::block(), mm * std::fabs(offset),
           mm * (now.move.end - now.move.center).length());
}

bool CompensatedPath::goes_along_arc(ig::Block& b, const ContourMotion& now, Phase phase, const Point2& from,
                                     const Point2& to, double offset) const {
  if (phase != offsetting) return false;
  if (!now.move.fits(offset)) {
    report_narrow_arc(b, now, offset);
    b.alarm();
    return false;
  }
  const double way = now.move.way(from, to, offset);
  if (way < -same_point_mm) {
    if (interference_ != Interference::ignore) {
      b.report(ig::diag("ISO-0467"), ig::Where::block(), ahead_.scale(b) * -way);
      b.alarm();
    }
    return false;
  }
  return now.move.is_arc && way > same_point_mm;
}

bool CompensatedPath::is_sound(const Corner& corner) {
  const auto is_position = [](const Point2& p) { return std::fabs(p.u) < 1e9 && std::fabs(p.v) < 1e9; };
  bool is_sound = is_position(corner.leave);
  for (std::size_t i = 0; i < corner.count; ++i) is_sound = is_sound && is_position(corner.steps[i].to);
  return is_sound;
}

ToolSteps::Manner CompensatedPath::take_event(ig::Block& b) {
  if (!manner_) manner_ = event_.take(b);
  return *manner_;
}

void CompensatedPath::finish(ig::Block& b) {
  if (const auto term = b.get(term_)) b.set(compound_, *term);
  const std::uint32_t turned = rotary_.fresh(b);
  PartialAngles rotary = rotary_.get(b);
  rotary.mask &= turned;
  steps_.finish(b, rotary);
  keep_position(b);
}

void CompensatedPath::keep_position(ig::Block& b) {
  const auto machine = b.to_machine(tool_.at);
  if (machine) {
    tool_.machine = *machine;
    if (b.has(compound_))
      b.set(machine_, *machine);
    else
      b.amend(machine_, *machine);
  }
  const ig::Vec3 vector = tool_.at - programmed_;
  b.set(vector_, rounded(vector));
}

}  // namespace iso
