/// The distance between the tool and moves of the contour that are not neighbours of its own move. In the plane;
/// lengths in mm.
#pragma once

#include <isogloss/cnc/contour_move.hpp>

namespace iso {

using namespace ig::cnc;

/// The distance from a point to the nearest point of a move.
inline double distance(const ContourMove& move, const Point2& p) {
  const double to_ends = std::fmin((p - move.start).length(), (p - move.end).length());
  if (!move.is_arc) {
    const Point2 way = move.end - move.start;
    const double square = dot(way, way), along = dot(p - move.start, way);
    if (along <= 0 || along >= square) return to_ends;
    return std::fabs(cross(way, p - move.start)) / std::sqrt(square);
  }
  const double to_center = (p - move.center).length();
  if (to_center < same_point_mm) return to_ends;
  const double whole = sweep(move.start, move.end, move.center, move.is_ccw);
  const bool lies_beside = std::fabs(sweep(move.start, p, move.center, move.is_ccw)) <= std::fabs(whole);
  return lies_beside ? std::fabs(to_center - (move.start - move.center).length()) : to_ends;
}

/// The point of a move at the fraction t: 0 is its start, 1 its end.
inline Point2 place_on(const ContourMove& move, double t) {
  if (!move.is_arc) return move.start + t * (move.end - move.start);
  const double angle = t * sweep(move.start, move.end, move.center, move.is_ccw);
  const Point2 out = move.start - move.center;
  return move.center + std::cos(angle) * out + std::sin(angle) * left_of(out);
}

/// The least distance between two moves: exact for straight moves; for arcs computed from sample points, so that the
/// result may be a little too large.
inline double gap(const ContourMove& a, const ContourMove& b) {
  const auto beside = [](const ContourMove& one, const ContourMove& other) {
    const int places = one.is_arc ? 16 : 1;
    double nearest = distance(other, one.end);
    for (int i = 0; i < places; ++i) nearest = std::fmin(nearest, distance(other, place_on(one, double(i) / places)));
    return nearest;
  };
  if (!a.is_arc && !b.is_arc) {
    const Point2 u = a.end - a.start, v = b.end - b.start;
    const bool parts_b = cross(u, b.start - a.start) * cross(u, b.end - a.start) < 0;
    if (parts_b && cross(v, a.start - b.start) * cross(v, a.end - b.start) < 0) return 0;
  }
  return std::fmin(beside(a, b), beside(b, a));
}

}  // namespace iso
