/// Geometry of arcs in the plane in force, without blocks: centre from a radius, sweep, length, turning points (Fanuc
/// manual, "Circular interpolation"). Lengths in mm, angles in radians, counter-clockwise positive. No function here
/// reports: the caller checks what the comment requires.
#pragma once

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace ig::cnc {

/// Two points that are nearer to each other than this, in mm, are the same point. A nanometre is far below the least
/// input increment of any control.
inline constexpr double same_point_mm = 1e-6;

/// A point of the plane: first and second axis.
struct Point2 {
  double u = 0, v = 0;
  friend constexpr Point2 operator-(const Point2& a, const Point2& b) { return {a.u - b.u, a.v - b.v}; }
  double length() const { return std::sqrt(u * u + v * v); }
};

/// The centre for a programmed radius in mm: a positive radius turns by at most half a circle, a negative one by more.
/// A radius that is too short for the chord is replaced by half the chord (radius_shortfall() tells). Start and end
/// must differ.
inline Point2 center_by_radius(const Point2& start, const Point2& end, double radius, bool is_ccw) {
  const Point2 chord = end - start;
  const double d = chord.length(), r = std::fabs(radius);
  const double height = std::sqrt(std::fmax(0.0, r - d / 2)) * std::sqrt(r + d / 2);  // no square that overflows
  const double side = (is_ccw ? 1 : -1) * (radius < 0 ? -1 : 1) * height / d;
  return {(start.u + end.u) / 2 - side * chord.v, (start.v + end.v) / 2 + side * chord.u};
}

/// By how many mm a programmed radius is too short for the chord; negative or 0 where it reaches.
inline double radius_shortfall(const Point2& start, const Point2& end, double radius) {
  return (end - start).length() / 2 - std::fabs(radius);
}

/// The signed angle from start to end about the centre, in radians; a whole circle where both lie in one direction from
/// the centre.
inline double sweep(const Point2& start, const Point2& end, const Point2& center, bool is_ccw) {
  constexpr double circle = 2 * std::numbers::pi;
  const double sense = is_ccw ? 1 : -1;
  if ((end - start).length() < same_point_mm) return sense * circle;
  const Point2 a = start - center, b = end - center;
  double turn = sense * std::atan2(a.u * b.v - a.v * b.u, a.u * b.u + a.v * b.v);
  if (turn < 0) turn += circle;
  // Rounding must not decide between nothing and a circle.
  if (turn * b.length() < same_point_mm) turn = circle;
  return sense * turn;
}

/// Length of the path in mm: an arc whose radius changes evenly from start to end, with a rise of `rise` mm along the
/// third axis.
inline double arc_length(const Point2& start, const Point2& end, const Point2& center, bool is_ccw, double rise) {
  const double radius = ((start - center).length() + (end - center).length()) / 2;
  const double in_plane = radius * std::fabs(sweep(start, end, center, is_ccw));
  return std::sqrt(in_plane * in_plane + rise * rise);
}

/// One coordinate of a point at (u, v) from the centre that runs along an arc: from + first * u + second * v, plus a
/// rise that grows evenly with the angle. Where start and end lie on circles of different radius, the larger circle is
/// used.
struct ArcCoordinate {
  double from = 0;               ///< value at the centre, mm
  double first = 0, second = 0;  ///< what one mm along u, and along v, adds
  double rise = 0;               ///< from the start to the end, mm
};

/// Calls visit(value), value in mm, for each extreme of the coordinate on the arc; a whole circle has two.
template <class Visit>
void visit_turning_points(const ArcCoordinate& along, const Point2& start, const Point2& end, const Point2& center,
                          bool is_ccw, Visit visit) {
  constexpr double circle = 2 * std::numbers::pi;
  const double turn = sweep(start, end, center, is_ccw);
  const Point2 out = start - center;
  const double radius = std::fmax(out.length(), (end - center).length());
  const double reach = radius * std::sqrt(along.first * along.first + along.second * along.second);
  if (turn == 0 || !(reach > std::fabs(along.rise / turn))) return;
  // reach * cos(angle - crest) + rise * (angle - begin) / turn, whose derivative is zero at two angles of each turn
  const double crest = std::atan2(along.second, along.first), begin = std::atan2(out.v, out.u);
  const double ahead = std::asin(along.rise / turn / reach);
  const double low = std::fmin(0.0, turn), high = std::fmax(0.0, turn);
  for (const double root : {crest + ahead - begin, crest + std::numbers::pi - ahead - begin}) {
    const double angle = root + circle * std::ceil((low - root) / circle);
    if (angle > high) continue;
    visit(along.from + reach * std::cos(begin + angle - crest) + along.rise * (angle / turn));
  }
}

}  // namespace ig::cnc
