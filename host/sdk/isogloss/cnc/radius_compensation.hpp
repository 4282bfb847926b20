/// Corners under cutter radius compensation, in the plane and without blocks: what joins the offsets of two moves
/// (Fanuc manual, "Details of cutter compensation"). Lengths in mm; offsets are signed, positive to the left.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "isogloss/cnc/contour_move.hpp"

namespace ig::cnc {

/// How the tool passes a corner; no_solution: the offsets of the two moves do not cross.
enum class CornerKind { tangent, inner, obtuse, acute, round, square, crossing, no_solution };

/// The passage from one move to the next: the tool leaves the first move at `leave` and makes `count` steps.
struct Corner {
  struct Step {
    Point2 to;
    bool is_arc = false;  ///< an arc about the corner of the contour
    bool is_ccw = false;
  };
  CornerKind kind = CornerKind::square;
  Point2 leave{};
  std::array<Step, 3> steps{};
  std::size_t count = 0;

  void step_to(const Point2& to) {
    if (!is_same(to, last())) steps[count++] = {to, false, false};
  }
  void arc_to(const Point2& to, bool is_ccw) {
    if (!is_same(to, last())) steps[count++] = {to, true, is_ccw};
  }
  const Point2& last() const { return count == 0 ? leave : steps[count - 1].to; }
};

/// What the tool does outside a corner: straight lines, or an arc about the corner.
enum class OuterCorner { lines, arc };

namespace detail {

/// The offset of a move near one of its ends: the line through a point, or a circle.
struct OffsetCurve {
  Point2 point, direction;
  bool is_circle;
  Point2 center;
  double radius;
};

inline OffsetCurve curve_at(const ContourMove& move, const Point2& point, const Point2& direction, double offset) {
  const Point2 touched = point + offset * left_of(direction);
  return {touched, direction, move.is_arc, move.center, move.is_arc ? move.path_radius(point, offset) : 0};
}

struct Crossings {
  std::array<Point2, 2> points{};
  std::size_t count = 0;
};

inline Crossings cross_lines(const OffsetCurve& a, const OffsetCurve& b) {
  const double c = cross(a.direction, b.direction);
  if (std::fabs(c) < 1e-12) return {};
  return {{a.point + (cross(b.point - a.point, b.direction) / c) * a.direction}, 1};
}

inline Crossings cross_line_circle(const OffsetCurve& line, const OffsetCurve& circle) {
  const Point2 to_center = circle.center - line.point;
  const double along = dot(to_center, line.direction), beside = cross(line.direction, to_center);
  const double square = (circle.radius - beside) * (circle.radius + beside);
  if (circle.radius <= 0 || square < -same_point_mm * circle.radius) return {};
  const double half = std::sqrt(std::fmax(0.0, square));
  return {{line.point + (along - half) * line.direction, line.point + (along + half) * line.direction}, 2};
}

inline Crossings cross_circles(const OffsetCurve& a, const OffsetCurve& b) {
  const Point2 between = b.center - a.center;
  const double d = between.length();
  if (a.radius <= 0 || b.radius <= 0 || d < same_point_mm) return {};
  const double along = (d + (a.radius - b.radius) * (a.radius + b.radius) / d) / 2;
  const double square = (a.radius - along) * (a.radius + along);
  if (square < -same_point_mm * a.radius) return {};
  const double half = std::sqrt(std::fmax(0.0, square));
  const Point2 unit = (1 / d) * between, foot = a.center + along * unit;
  return {{foot + half * left_of(unit), foot - half * left_of(unit)}, 2};
}

/// The crossing of two offsets that is nearest to `near`; nothing where they do not cross.
inline std::optional<Point2> crossing(const OffsetCurve& a, const OffsetCurve& b, const Point2& near) {
  const Crossings all = a.is_circle   ? (b.is_circle ? cross_circles(a, b) : cross_line_circle(b, a))
                        : b.is_circle ? cross_line_circle(a, b)
                                      : cross_lines(a, b);
  if (all.count == 0) return std::nullopt;
  if (all.count == 1) return all.points[0];
  return (all.points[0] - near).length() <= (all.points[1] - near).length() ? all.points[0] : all.points[1];
}

}  // namespace detail

/// The tool stands square to the move at its end.
inline Corner square_corner(const ContourMove& move, double offset) {
  return {CornerKind::square, move.offset_end(offset), {}, 0};
}

/// The passage from `a` to `b`, which begins where `a` ends, on the same side of both.
inline Corner corner(const ContourMove& a, const ContourMove& b, double offset, OuterCorner outer) {
  // A smaller bend is none: it would move a point by no more than the offset times the bend, in radians.
  constexpr double no_bend = 3e-8;
  const Point2 u1 = a.direction_at_end(), u2 = b.direction_at_start();
  const Point2 q1 = a.offset_end(offset), q2 = b.offset_start(offset);
  const double bend = cross(u1, u2), along = dot(u1, u2);
  Corner out{CornerKind::tangent, q1, {}, 0};
  if (offset == 0 || (std::fabs(bend) < no_bend && along > 0)) return out;

  // A way back along the same line has no inner side, so the tool goes round its end, whatever rounding makes of it.
  const bool is_reversal = std::fabs(bend) < no_bend;
  if (bend * offset > 0 && !is_reversal) {
    const auto at = detail::crossing(detail::curve_at(a, a.end, u1, offset), detail::curve_at(b, b.start, u2, offset),
                                     0.5 * (q1 + q2));
    const bool is_tangent = !at && (q1 - q2).length() < std::fmax(a.slack_mm, b.slack_mm);
    out.kind = at ? CornerKind::inner : is_tangent ? CornerKind::tangent : CornerKind::no_solution;
    if (at)
      out.leave = *at;
    else if (is_tangent)
      out.leave = q2;
    else
      out.step_to(q2);
    return out;
  }
  if (outer == OuterCorner::arc) {
    out.kind = CornerKind::round;
    out.arc_to(q2, offset < 0);
    return out;
  }
  // An obtuse corner is passed where the two offset lines cross, a sharp one on lines square to both sides; an arc is
  // left where it ends.
  constexpr double right_angle = -1e-9;
  const bool is_obtuse = along > right_angle;
  out.kind = is_obtuse ? CornerKind::obtuse : CornerKind::acute;
  const Point2 first =
      is_obtuse ? a.end + (offset / (1 + along)) * (left_of(u1) + left_of(u2)) : q1 + std::fabs(offset) * u1;
  if (a.is_arc)
    out.step_to(first);
  else
    out.leave = first;
  if (!is_obtuse) out.step_to(q2 - std::fabs(offset) * u2);
  if (b.is_arc) out.step_to(q2);
  return out;
}

/// An outer corner where the tool goes on along both offsets to the point where they cross; nothing at other corners,
/// where the contour bends by more than `limit_deg`, and where the offsets do not cross.
inline std::optional<Corner> outer_crossing(const ContourMove& a, const ContourMove& b, double offset,
                                            double limit_deg) {
  constexpr double no_bend = 3e-8, degree = 3.14159265358979323846 / 180, slack_deg = 1e-6;
  const Point2 u1 = a.direction_at_end(), u2 = b.direction_at_start();
  const double bend = cross(u1, u2);
  if (!(bend * offset < 0) || std::fabs(bend) < no_bend) return std::nullopt;
  if (std::atan2(std::fabs(bend), dot(u1, u2)) / degree > limit_deg + slack_deg) return std::nullopt;
  const Point2 q1 = a.offset_end(offset), q2 = b.offset_start(offset);
  const auto at = detail::crossing(detail::curve_at(a, a.end, u1, offset), detail::curve_at(b, b.start, u2, offset),
                                   0.5 * (q1 + q2));
  if (!at || dot(*at - q1, u1) < -same_point_mm || dot(q2 - *at, u2) < -same_point_mm) return std::nullopt;
  return Corner{CornerKind::obtuse, *at, {}, 0};
}

/// The tool goes on an arc about the point where two moves meet, also where that is no outer corner.
inline Corner arc_about_corner(const ContourMove& a, const ContourMove& b, double offset) {
  Corner out{CornerKind::round, a.offset_end(offset), {}, 0};
  out.arc_to(b.offset_start(offset), offset < 0);
  return out;
}

/// The move to `corner` whose offset begins at `from`: a line from there that touches the tool's circle about the
/// corner. Nothing within that circle.
inline std::optional<ContourMove> touching_move_from(const Point2& from, const Point2& corner, double offset) {
  const Point2 way = corner - from;
  const double distance = way.length();
  if (distance < std::fabs(offset) + same_point_mm) return std::nullopt;
  const double sine = offset / distance, cosine = std::sqrt((1 - sine) * (1 + sine));
  const Point2 along = (1 / distance) * way, direction = cosine * along + sine * left_of(along);
  return ContourMove{corner - (distance * cosine) * direction, corner, false, {}, false};
}

/// The move from `corner` whose offset ends at `to`.
inline std::optional<ContourMove> touching_move_to(const Point2& corner, const Point2& to, double offset) {
  const auto back = touching_move_from(to, corner, -offset);
  if (!back) return std::nullopt;
  return ContourMove{corner, back->start, false, {}, false};
}

/// The crossing of the offsets of two moves that are no neighbours; nothing unless the crossing shortens both of them.
inline std::optional<Corner> meet(const ContourMove& a, const ContourMove& b, double offset, const Point2& from) {
  if (!a.fits(offset) || !b.fits(offset)) return std::nullopt;
  const auto at = detail::crossing(detail::curve_at(a, a.end, a.direction_at_end(), offset),
                                   detail::curve_at(b, b.start, b.direction_at_start(), offset),
                                   0.5 * (a.offset_end(offset) + b.offset_start(offset)));
  if (!at || a.way(from, *at, offset) < -same_point_mm || a.way(*at, a.offset_end(offset), offset) < -same_point_mm ||
      b.way(b.offset_start(offset), *at, offset) < -same_point_mm)
    return std::nullopt;
  return Corner{CornerKind::inner, *at, {}, 0};
}

/// The passage from `a`, with the tool on one side, to `b`, with the tool on the other: where the offsets of two
/// straight moves cross within both, else by a step across the contour.
inline Corner change_of_side(const ContourMove& a, double offset_a, const ContourMove& b, double offset_b) {
  Corner out{CornerKind::crossing, a.offset_end(offset_a), {}, 0};
  if (!a.is_arc && !b.is_arc) {
    const auto at = detail::crossing(detail::curve_at(a, a.end, a.direction_at_end(), offset_a),
                                     detail::curve_at(b, b.start, b.direction_at_start(), offset_b), a.end);
    const auto lies_on = [&](const ContourMove& m, const Point2& p) {
      const double s = dot(p - m.start, m.direction_at_start());
      return s >= 0 && s <= (m.end - m.start).length();
    };
    if (at && lies_on(a, *at) && lies_on(b, *at)) {
      out.leave = *at;
      return out;
    }
  }
  out.step_to(b.offset_start(offset_b));
  return out;
}

/// The end of `a` before a cancelling move whose direction the program gives (G40 with I, J or K). `direction` must not
/// be 0; its length has no meaning.
inline Corner directed_end(const ContourMove& a, double offset, const Point2& direction) {
  const Point2 unit = (1 / direction.length()) * direction;
  const ContourMove wall{a.end, a.end + unit, false, {}, false};
  const Point2 q1 = a.offset_end(offset), q2 = wall.offset_start(offset);
  Corner out{CornerKind::square, q1, {}, 0};
  if (const auto at = detail::crossing(detail::curve_at(a, a.end, a.direction_at_end(), offset),
                                       detail::curve_at(wall, a.end, unit, offset), 0.5 * (q1 + q2))) {
    out.kind = CornerKind::inner;
    out.leave = *at;
  }
  return out;
}

}  // namespace ig::cnc
