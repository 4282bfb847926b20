/// One move of a contour in the plane, without blocks, and the path of the tool's centre beside it. Lengths in mm. An
/// offset is signed: positive is to the left of the direction of travel.
#pragma once

#include "isogloss/cnc/arc.hpp"

namespace ig::cnc {

constexpr Point2 operator+(const Point2& a, const Point2& b) { return {a.u + b.u, a.v + b.v}; }
constexpr Point2 operator*(double s, const Point2& a) { return {s * a.u, s * a.v}; }
constexpr double dot(const Point2& a, const Point2& b) { return a.u * b.u + a.v * b.v; }
constexpr double cross(const Point2& a, const Point2& b) { return a.u * b.v - a.v * b.u; }
constexpr Point2 left_of(const Point2& direction) { return {-direction.v, direction.u}; }
inline bool is_same(const Point2& a, const Point2& b) { return (a - b).length() < same_point_mm; }

/// One move of the contour: a straight line, or an arc about a centre. Its length must not be 0.
struct ContourMove {
  Point2 start, end;
  bool is_arc = false;
  Point2 center{};
  bool is_ccw = false;
  double slack_mm = same_point_mm;  ///< tolerance: of an arc's ends to its circle, of its radius to the tool's

  Point2 direction_at_start() const { return is_arc ? tangent(start) : unit(end - start); }
  Point2 direction_at_end() const { return is_arc ? tangent(end) : unit(end - start); }
  /// The tool's centre where the tool touches the start, and the end, of the move.
  Point2 offset_start(double offset) const { return start + offset * left_of(direction_at_start()); }
  Point2 offset_end(double offset) const { return end + offset * left_of(direction_at_end()); }
  /// Radius of the tool centre's path along an arc; negative where the tool does not fit in. At 0 the centre rests.
  double path_radius(const Point2& at, double offset) const {
    const double radius = (at - center).length() + (is_ccw ? -offset : offset);
    return radius < 0 && radius > -slack_mm ? 0 : radius;
  }
  /// True when the tool fits into the arc; always for a straight line.
  bool fits(double offset) const {
    return !is_arc || std::fmin(path_radius(start, offset), path_radius(end, offset)) >= 0;
  }

  /// How far the tool's centre goes along the move from `from` to `to`, which lie on its offset; negative where it
  /// would have to go back. On an arc the length is measured on the centre's path.
  double way(const Point2& from, const Point2& to, double offset) const {
    if (!is_arc) return dot(to - from, direction_at_end());
    const double whole = std::fabs(sweep(start, end, center, is_ccw));
    return (whole - turn(start, from) + turn(end, to)) * path_radius(end, offset);
  }

 private:
  static Point2 unit(const Point2& v) { return (1 / v.length()) * v; }
  Point2 tangent(const Point2& at) const {
    const Point2 left = left_of(unit(at - center));
    return is_ccw ? left : -1.0 * left;
  }
  /// The angle from one point to another about the centre, at most half a circle, positive in the sense of the arc.
  double turn(const Point2& from, const Point2& to) const {
    const Point2 a = from - center, b = to - center;
    const double angle = std::atan2(cross(a, b), dot(a, b));
    return is_ccw ? angle : -angle;
  }
};

}  // namespace ig::cnc
