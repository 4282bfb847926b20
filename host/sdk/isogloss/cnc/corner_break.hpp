/// Geometry of chamfers and roundings at the corner between two moves, in the plane and without blocks (Fanuc manual,
/// "Optional chamfering and corner rounding"). Lengths in mm.
#pragma once

#include "isogloss/cnc/radius_compensation.hpp"

namespace ig::cnc {

/// What replaces the corner of two moves: the first move ends at `begin`, the second starts at `end`.
struct BrokenCorner {
  Point2 begin, end;
  bool is_arc = false;
  Point2 center{};
  bool is_ccw = false;

  ContourMove move() const { return {begin, end, is_arc, center, is_ccw}; }
};

/// What the size of a corner means. legs: the distance from the corner to both ends of a chamfer; length: the length of
/// the chamfer itself; rounding: the radius.
enum class CornerShape { legs, length, rounding };

/// Why a corner stays as programmed. `no`: it is broken. `length_at_arc`: a chamfer given by its length needs two
/// straight moves.
enum class Unbroken { no, straight_on, doubles_back, no_place, first_too_short, second_too_short, length_at_arc };

struct CornerBreaking {
  Unbroken why = Unbroken::no;
  BrokenCorner corner;
};

namespace detail {

/// The point of a move at the straight distance `chord` from its end, or from its start; nothing where the chord is
/// longer than the diameter of the arc.
inline std::optional<Point2> at_chord(const ContourMove& m, double chord, bool from_end) {
  const Point2 corner = from_end ? m.end : m.start;
  if (!m.is_arc) return corner + (from_end ? -chord : chord) * m.direction_at_end();
  const Point2 out = corner - m.center;
  const double radius = out.length();
  if (chord > 2 * radius) return std::nullopt;
  const double turn = 2 * std::asin(chord / (2 * radius)) * (m.is_ccw == from_end ? -1 : 1);
  const double c = std::cos(turn), s = std::sin(turn);
  return m.center + Point2{c * out.u - s * out.v, s * out.u + c * out.v};
}

/// The point of a line or a circle that lies nearest to `p`.
inline Point2 foot(const ContourMove& m, const Point2& corner, const Point2& p) {
  if (!m.is_arc) {
    const Point2 direction = m.direction_at_end();
    return corner + dot(p - corner, direction) * direction;
  }
  const Point2 out = p - m.center;
  return m.center + ((corner - m.center).length() / out.length()) * out;
}

/// Does `p` lie on the move, between `from` and its end? A straight move may be used up to its end point, an arc may
/// not.
inline bool lies_within(const ContourMove& m, const Point2& from, const Point2& p) {
  if (!m.is_arc) {
    const Point2 direction = m.direction_at_end();
    return dot(p - from, direction) >= -same_point_mm && dot(m.end - p, direction) >= -same_point_mm;
  }
  if (is_same(p, from) || is_same(p, m.end)) return false;
  return std::fabs(sweep(from, p, m.center, m.is_ccw)) < std::fabs(sweep(from, m.end, m.center, m.is_ccw));
}

inline Unbroken find_rounding(const ContourMove& a, const ContourMove& b, double radius, BrokenCorner& out) {
  const Point2 u1 = a.direction_at_end(), u2 = b.direction_at_start();
  out.is_arc = true;
  out.is_ccw = cross(u1, u2) > 0;
  const double beside = out.is_ccw ? radius : -radius;
  const auto center = crossing(curve_at(a, a.end, u1, beside), curve_at(b, b.start, u2, beside), a.end);
  if (!center) return Unbroken::no_place;
  if ((a.is_arc && is_same(*center, a.center)) || (b.is_arc && is_same(*center, b.center))) return Unbroken::no_place;
  out.center = *center;
  out.begin = foot(a, a.end, *center);
  out.end = foot(b, b.start, *center);
  return Unbroken::no;
}

inline Unbroken find_chamfer(const ContourMove& a, const ContourMove& b, double size, BrokenCorner& out) {
  const auto begin = at_chord(a, size, true), end = at_chord(b, size, false);
  if (!begin) return Unbroken::first_too_short;
  if (!end) return Unbroken::second_too_short;
  out.begin = *begin;
  out.end = *end;
  return Unbroken::no;
}

}  // namespace detail

/// Breaks the corner from `a`, whose part before `a_begin` is already used up by the corner before, to `b`, which
/// begins where `a` ends. Directions that differ by at most one degree are the same, or opposite (straight_on,
/// doubles_back): they have no corner. `size` is positive.
inline CornerBreaking break_corner(const ContourMove& a, const Point2& a_begin, const ContourMove& b, double size,
                                   CornerShape shape) {
  constexpr double sine_of_a_degree = 0.017452406437283512;
  const Point2 u1 = a.direction_at_end(), u2 = b.direction_at_start();
  CornerBreaking out;
  if (std::fabs(cross(u1, u2)) <= sine_of_a_degree) {
    out.why = dot(u1, u2) > 0 ? Unbroken::straight_on : Unbroken::doubles_back;
    return out;
  }
  if (shape == CornerShape::length) {
    if (a.is_arc || b.is_arc) {
      out.why = Unbroken::length_at_arc;
      return out;
    }
    size /= 2 * std::sqrt((1 + dot(u1, u2)) / 2);
  }
  out.why = shape == CornerShape::rounding ? detail::find_rounding(a, b, size, out.corner)
                                           : detail::find_chamfer(a, b, size, out.corner);
  if (out.why != Unbroken::no) return out;
  if (!detail::lies_within(a, a_begin, out.corner.begin))
    out.why = Unbroken::first_too_short;
  else if (!detail::lies_within(b, b.start, out.corner.end))
    out.why = Unbroken::second_too_short;
  return out;
}

/// The part of a move that the corners at its two ends leave. A line keeps its direction even where nothing of it is
/// left.
inline ContourMove between_corners(ContourMove m, const Point2& begin, const Point2& end) {
  const Point2 direction = m.direction_at_end();
  m.start = m.is_arc || !is_same(begin, end) ? begin : end - direction;
  m.end = end;
  return m;
}

}  // namespace ig::cnc
