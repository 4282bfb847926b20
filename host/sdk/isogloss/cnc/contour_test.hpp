/// Helpers of the tests of contour geometry: moves in one line, and points compared to 1e-9 mm.
#pragma once

#include <catch2/catch.hpp>

#include "isogloss/cnc/contour_move.hpp"

namespace ig::cnc {

inline ContourMove line(Point2 start, Point2 end) { return {start, end, false, {}, false}; }
inline ContourMove arc(Point2 start, Point2 end, Point2 center, bool is_ccw) {
  return {start, end, true, center, is_ccw};
}

inline void check_point(const Point2& got, const Point2& wanted) {
  CHECK(got.u == Approx(wanted.u).margin(1e-9));
  CHECK(got.v == Approx(wanted.v).margin(1e-9));
}

}  // namespace ig::cnc
