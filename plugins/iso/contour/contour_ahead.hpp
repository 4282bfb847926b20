/// The next moves of the contour in the plane, as far as the control reads ahead.
#pragma once

#include <isogloss/cnc/corner_break_state.hpp>
#include <isogloss/cnc/radius_compensation.hpp>
#include <isogloss/cnc/scan.hpp>

#include "contour/contour_motion.hpp"

namespace iso {

using namespace ig::cnc;

/// The control does not count a line that holds only a comment as a block.
inline bool is_comment_line(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos || (text[first] != '(' && text[first] != ';')) return false;
  const std::size_t last = text.find_last_not_of(" \t\r;");
  return text[first] == ';' || (last != std::string_view::npos && text[last] == ')' && text.find(')') == last);
}

/// Whether the words of a block are only those that a call or a return may have without being an NC statement: O, N, P
/// and L beside one M code.
inline bool is_call_alone(std::string_view text) {
  std::size_t codes = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = to_upper(text[i]);
    if (c == ';') break;
    if (c == '(' || c == '[' || c == '<') {
      i = skip_bracketed(text, i) - 1;
    } else if (c == 'M') {
      if (++codes > 1) return false;
    } else if (is_letter(c) && std::string_view("ONPL").find(c) == std::string_view::npos) {
      return false;
    }
  }
  return codes == 1;
}

/// A member of the syntax that looks ahead.
class ContourAhead {
 public:
  static constexpr std::uint32_t window = 16;

  /// What follows in the plane after the block.
  struct Next {
    enum class Kind { none, move, barrier, too_far };
    Kind kind = Kind::none;
    double offset = 0;  ///< 0: the next move cancels compensation
    bool is_rapid = false;
    ContourMove move{};
    Point2 direction{};            ///< of the cancelling move, where the program gives one
    bool cancels_at_rest = false;  ///< the cancelling code stands in a block without a move, before the move
    bool goes_round = false;       ///< from the last point of the contour to behind it
  };

  /// The offset in coordinates of the program: a frame that scales (SCALE) does not scale the tool.
  double offset_in_force(ig::Block& b) const {
    const bool is_left = b.is(side_, left_);
    if (!is_left && !b.is(side_, right_)) return 0;
    const double radius = b.get_or(radius_, 0.0) / scale(b);
    return is_left ? radius : -radius;
  }
  /// The length in the machine of one mm of the program. Digits below 1e-9 are noise of a rotated frame.
  double scale(ig::Block& b) const {
    ig::Vec3 axis;
    axis[plane_(b).first] = 1;
    const auto origin = b.to_machine({}), unit = b.to_machine(axis);
    if (!origin || !unit) return 1;
    const double scale = std::round(length(*unit - *origin) * 1e9) / 1e9;
    return scale > 0 ? scale : 1;
  }

  Next next(ig::Block& b, const PlaneAxes& plane, std::int64_t rests_allowed) const {
    Next next;
    bool other_frame = false, cancels = false;
    std::int64_t rests = 0;
    for (std::uint32_t k = 1; k <= window; ++k) {
      std::optional<ig::Block> following = b.ahead(k);
      if (!following) return next;
      ig::Block& ahead = *following;
      other_frame |= ahead.frame_changed();
      const ContourMotion motion = motion_(ahead);
      if (motion.kind == ContourMotion::Kind::by_steps || !(motion.plane == plane)) {
        next.kind = Next::Kind::barrier;
        return next;
      }
      if (motion.kind == ContourMotion::Kind::rest) {
        if (ahead.has(corner_arc_)) {
          next.kind = Next::Kind::barrier;
          return next;
        }
        cancels |= offset_in_force(ahead) == 0;
        if (counts(ahead) && ++rests > rests_allowed) break;
        continue;
      }
      next.kind = Next::Kind::move;
      next.offset = offset_in_force(ahead);
      next.is_rapid = ahead.get_or(is_rapid_, false);
      next.move = motion.move;
      next.cancels_at_rest = cancels;
      next.goes_round = ahead.get_or(goes_round_, false);
      next.direction = ContourMotionOf::in_plane(plane, ahead.get(cancel_direction_).or_else({}));
      if (other_frame && !bring_here(b, ahead, motion, next.move)) next.kind = Next::Kind::barrier;
      return next;
    }
    if (!cancels) next.kind = Next::Kind::too_far;
    return next;
  }

  /// The moves that follow on the same side at the same distance, as far as the control reads. The first one begins at
  /// `start` where that is given, after a broken corner.
  using Moves = std::array<ContourMove, 8>;
  /// Which of the moves cut at a constant height: by feed, and without a move across the plane.
  struct Walls {
    double height = 0;
    std::array<bool, std::tuple_size_v<Moves>> are{};
  };
  std::size_t moves(ig::Block& b, const PlaneAxes& plane, double offset, std::int64_t rests_allowed,
                    const std::optional<Point2>& start, Moves& moves, Walls* walls = nullptr) const {
    std::array<Break, 8> breaks{};
    std::size_t count = 0;
    bool other_frame = false;
    std::int64_t rests = 0;
    for (std::uint32_t k = 1; k <= window && count < moves.size(); ++k) {
      std::optional<ig::Block> following = b.ahead(k);
      if (!following) break;
      ig::Block& ahead = *following;
      other_frame |= ahead.frame_changed();
      const ContourMotion motion = motion_(ahead);
      if (motion.kind == ContourMotion::Kind::by_steps || !(motion.plane == plane)) break;
      if (offset_in_force(ahead) != offset) break;
      if (motion.kind == ContourMotion::Kind::rest) {
        if (ahead.has(corner_arc_)) break;
        if (counts(ahead) && ++rests > rests_allowed) break;
        continue;
      }
      rests = 0;
      moves[count] = motion.move;
      if (other_frame && !bring_here(b, ahead, motion, moves[count])) break;
      breaks[count] = break_.get(ahead);
      if (walls != nullptr)
        walls->are[count] = !other_frame && !ahead.get_or(is_rapid_, false) &&
                            std::fabs(motion.from[plane.tool] - walls->height) < same_point_mm &&
                            std::fabs(motion.to[plane.tool] - walls->height) < same_point_mm;
      ++count;
    }
    return with_corners(moves, count, start.value_or(moves[0].start), breaks, walls);
  }

  /// The way to the contour of a tool that starts behind it and goes round its first point; nothing elsewhere. Behind
  /// is the other side of the tangent at that point.
  std::optional<ContourMove> starts_behind(const ig::Block& b, const ContourMove& now, const ContourMove& next,
                                           double offset) const {
    if (!b.get_or(goes_round_, false) || !is_behind(now.start, now.end, next.direction_at_start(), offset))
      return std::nullopt;
    return touching_move_from(now.start, now.end, offset);
  }
  /// The same at the end: the way off the contour.
  static std::optional<ContourMove> leaves_behind(const ContourMove& now, const Next& next, double offset) {
    if (!next.goes_round || next.move.is_arc || !is_behind(next.move.end, now.end, now.direction_at_end(), offset))
      return std::nullopt;
    return touching_move_to(now.end, next.move.end, offset);
  }

 private:
  static bool is_behind(const Point2& tool, const Point2& corner, const Point2& tangent, double offset) {
    return offset * dot(tool - corner, left_of(tangent)) < -same_point_mm * std::fabs(offset);
  }

  using Break = std::optional<CornerBreakState::Corner>;

  /// Macro statements, macro calls, and calls and returns without other words are no blocks without a move for the
  /// control (Fanuc operator's manual, "Macro statements and NC statements").
  bool counts(const ig::Block& ahead) const {
    if (ahead.is_raised(macro_statement_) || ahead.is_raised(macro_call_)) return false;
    const std::string_view text = ahead.source();
    const bool is_call = ahead.has(call_) || ahead.has(return_);
    return !is_comment_line(text) && !(is_call && is_call_alone(text));
  }

  /// The move of a later block, mapped into the frame of this block.
  static bool bring_here(ig::Block& b, ig::Block& ahead, const ContourMotion& motion, ContourMove& move) {
    const auto bring = [&](const ig::Vec3& p) -> std::optional<Point2> {
      const auto machine = ahead.to_machine(p);
      const auto here = machine ? b.to_program(*machine) : std::nullopt;
      return here ? std::optional(ContourMotionOf::in_plane(motion.plane, rounded(*here))) : std::nullopt;
    };
    ig::Vec3 center = motion.from;
    center[motion.plane.first] = move.center.u;
    center[motion.plane.second] = move.center.v;
    const auto start = bring(motion.from), end = bring(motion.to), middle = bring(center);
    if (!start || !end || !middle) return false;
    move.start = *start;
    move.end = *end;
    move.center = *middle;
    return true;
  }

  /// The moves with the chamfers and roundings between them.
  static std::size_t with_corners(Moves& moves, std::size_t count, Point2 begin, const std::array<Break, 8>& breaks,
                                  Walls* walls) {
    Moves out;
    Walls walls_out;
    std::size_t n = 0;
    for (std::size_t i = 0; i < count && n < out.size(); ++i) {
      const ContourMove& move = moves[i];
      CornerBreaking broken;
      broken.why = Unbroken::straight_on;
      if (breaks[i] && i + 1 < count)
        broken = break_corner(move, begin, moves[i + 1], breaks[i]->size, breaks[i]->shape);
      const bool is_broken = broken.why == Unbroken::no;
      if (walls != nullptr) walls_out.are[n] = walls->are[i];
      out[n++] = between_corners(move, begin, is_broken ? broken.corner.begin : move.end);
      if (is_broken && n < out.size()) {
        if (walls != nullptr) walls_out.are[n] = walls->are[i] && walls->are[i + 1];
        out[n++] = broken.corner.move();
      }
      begin = is_broken ? broken.corner.end : move.end;
    }
    moves = out;
    if (walls != nullptr) walls->are = walls_out.are;
    return n;
  }

  PlaneInForce plane_;
  ContourMotionOf motion_;
  ig::In<ig::Symbol> side_{"RadiusCompensation.Side"};
  ig::In<double> radius_{"RadiusCompensation.Radius_mm"};
  ig::Xyz cancel_direction_{"RadiusCompensation.CancelDirection", ig::read, {ig::Life::block, "mm", ""}};
  ig::In<bool> is_rapid_{"MotionEvent.IsRapid"};
  ig::In<bool> goes_round_{
      "RadiusCompensation.GoesRoundEnds",
      ig::read,
      {ig::Life::modal, "", "A tool behind the contour goes round its first and last point, not straight to it."}};
  ig::In<ig::Symbol> corner_arc_{"RadiusCompensation.CornerArc"};
  ig::In<ig::Symbol> call_{"SubProgramCall.Term"}, return_{"SubProgramReturn.Term"};
  ig::Signal macro_statement_{"Parsing.~MacroStatement", ig::read}, macro_call_{"Parsing.~MacroCall", ig::read};
  CornerBreakState break_{ig::read};
  ig::Name left_{"Left"}, right_{"Right"};
};

}  // namespace iso
