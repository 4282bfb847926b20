/// Geometry of arcs in their plane. Lengths in mm, angles in radians, counter-clockwise positive.
#pragma once

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace ig::cnc {

/// Below this two points are the same: a nanometre, far under any control's least increment.
inline constexpr double same_point_mm = 1e-6;

/// A point of the plane: first and second axis.
struct Point2 {
  double u = 0, v = 0;
  friend constexpr Point2 operator-(const Point2& a, const Point2& b) { return {a.u - b.u, a.v - b.v}; }
  double length() const { return std::sqrt(u * u + v * v); }
};

/// The centre for a programmed radius: radius > 0 turns by at most half a circle, radius < 0 by more. A radius that
/// does not reach counts as half the distance. Start and end differ.
inline Point2 center_by_radius(const Point2& start, const Point2& end, double radius, bool is_ccw) {
  const Point2 chord = end - start;
  const double d = chord.length();
  const double height = std::sqrt(std::fmax(0.0, radius * radius - d * d / 4));
  const double side = (is_ccw ? 1 : -1) * (radius < 0 ? -1 : 1) * height / d;
  return {(start.u + end.u) / 2 - side * chord.v, (start.v + end.v) / 2 + side * chord.u};
}

/// By how much a programmed radius is too short to reach; negative where it reaches.
inline double radius_shortfall(const Point2& start, const Point2& end, double radius) {
  return (end - start).length() / 2 - std::fabs(radius);
}

/// The signed turn, a whole circle where start and end are the same.
inline double sweep(const Point2& start, const Point2& end, const Point2& center, bool is_ccw) {
  constexpr double circle = 2 * std::numbers::pi;
  if ((end - start).length() < same_point_mm) return is_ccw ? circle : -circle;
  const Point2 a = start - center, b = end - center;
  double turn = std::atan2(a.u * b.v - a.v * b.u, a.u * b.u + a.v * b.v);
  if (is_ccw && turn < 0) turn += circle;
  if (!is_ccw && turn > 0) turn -= circle;
  return turn;
}

/// Length of the path: an arc whose radius changes evenly from start to end, and a rise along the third axis.
inline double arc_length(const Point2& start, const Point2& end, const Point2& center, bool is_ccw, double rise) {
  const double radius = ((start - center).length() + (end - center).length()) / 2;
  const double in_plane = radius * std::fabs(sweep(start, end, center, is_ccw));
  return std::sqrt(in_plane * in_plane + rise * rise);
}

/// One coordinate of a point that runs along an arc: from + first * (u of it) + second * (v of it), and a rise that
/// grows evenly with the angle. Where start and end lie on different circles the larger one counts.
struct ArcCoordinate {
  double from = 0;               ///< at the centre
  double first = 0, second = 0;  ///< what one mm along u and v adds
  double rise = 0;               ///< from the start to the end
};

/// Calls visit(value) where the coordinate turns back between start and end; a whole circle has two such places.
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
