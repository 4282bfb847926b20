/// Places that are narrower than the tool: moves that it cannot reach are left out, and necks are reported.
#include "contour/compensated_path.hpp"
#include "contour/contour_clearance.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

constexpr double least_turn = 0.996;   ///< 5 degrees
constexpr double least_cut_mm = 0.01;  ///< coordinates are rounded
constexpr std::size_t leads_away = 1;

}  // namespace

std::size_t CompensatedPath::following(ig::Block& b, const ContourMotion& now, double offset,
                                       ContourAhead::Moves& moves, ContourAhead::Walls* walls) const {
  const auto most = static_cast<std::size_t>(static_cast<std::int64_t>(compared_));
  const std::size_t count =
      std::min(most, ahead_.moves(b, now.plane, offset, rests_allowed_, next_start_, moves, walls));
  if (!inserted_) return count;
  const std::size_t kept = std::min(count, moves.size() - 1);
  const auto put_first = [kept](auto& list, const auto& first) {
    std::copy_backward(list.begin(), list.begin() + kept, list.begin() + kept + 1);
    list[0] = first;
  };
  put_first(moves, *inserted_);
  if (walls != nullptr) put_first(walls->are, true);
  return kept + 1;
}

std::optional<Corner> CompensatedPath::go_around(ig::Block& b, const ContourMotion& now, double offset,
                                                 const ContourAhead::Next& next, const Corner& corner) {
  const bool is_narrow = corner.kind == CornerKind::inner || corner.kind == CornerKind::no_solution;
  if (!is_narrow && next.move.fits(offset)) return std::nullopt;
  ContourAhead::Moves moves;
  const std::size_t count = following(b, now, offset, moves);
  const Point2 from = tool_.corner.count == 0 ? ContourMotionOf::in_plane(now.plane, tool_.at) : tool_.corner.last();
  std::optional<Corner> trial;
  if (corner.kind != CornerKind::no_solution) trial = corner;
  for (std::size_t n = 0; n < count; ++n) {
    if (n > 0) trial = iso::meet(now.move, moves[n], offset, from);
    if (!trial || !moves[n].fits(offset)) continue;
    const Point2 end = n + 1 < count ? iso::corner(moves[n], moves[n + 1], offset, OuterCorner::lines).leave
                                     : moves[n].offset_end(offset);
    if (moves[n].way(trial->last(), end, offset) < -same_point_mm) continue;
    if (n == 0) return std::nullopt;
    tool_.left_out = n;
    return trial;
  }
  return std::nullopt;
}

bool CompensatedPath::may_be_narrow(const ContourMotion& now, const ContourAhead::Next& next,
                                    const Corner& corner) const {
  if (interference_ == Interference::ignore || tool_.left_out > 0) return false;
  if (next.kind != ContourAhead::Next::Kind::move || next.offset == 0 || next.is_rapid) return false;
  if (corner.kind == CornerKind::no_solution) return false;
  return now.move.is_arc || next.move.is_arc ||
         dot(now.move.direction_at_end(), next.move.direction_at_start()) < least_turn;
}

void CompensatedPath::report_neck(ig::Block& b, const ContourMotion& now, double offset, const Corner& corner) {
  const double height = now.to[now.plane.tool];
  if (b.get_or(is_rapid_, false) || std::fabs(now.from[now.plane.tool] - height) > same_point_mm) return;
  if (!now.move.fits(offset)) return;
  ContourAhead::Moves moves;
  ContourAhead::Walls walls{height, {}};
  const std::size_t count = following(b, now, offset, moves, &walls);
  const Point2 from = tool_.corner.count == 0 ? ContourMotionOf::in_plane(now.plane, tool_.at) : tool_.corner.last();
  if (now.move.way(from, corner.leave, offset) < same_point_mm) return;
  const ContourMove path{from, corner.leave, now.move.is_arc, now.move.center, now.move.is_ccw};
  double deepest = least_cut_mm;
  for (std::size_t n = 2; n + leads_away < count; ++n)
    if (walls.are[n] && moves[n].fits(offset)) deepest = std::fmax(deepest, std::fabs(offset) - gap(path, moves[n]));
  if (deepest > least_cut_mm) b.report(ig::diag("ISO-0496"), ig::Where::block(), ahead_.scale(b) * deepest);
}

ig::Status CompensatedPath::leave_out(ig::Block& b, const ContourMotion& now, double offset) {
  --tool_.left_out;
  if (interference_ == Interference::alarm) {
    if (now.move.fits(offset))
      b.report(ig::diag("ISO-0476"), ig::Where::block());
    else
      report_narrow_arc(b, now, offset);
    b.alarm();
  }
  const ToolSteps::Manner manner = take_event(b);
  tool_.at[now.plane.tool] = now.to[now.plane.tool];
  steps_.line(b, tool_.at, manner);
  b.set(phase_, phases_[offsetting]);
  finish(b);
  return ig::Status::changed;
}

}  // namespace iso
