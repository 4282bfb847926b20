#include "isogloss/cnc/corner_break.hpp"

#include "isogloss/cnc/contour_test.hpp"

using namespace ig::cnc;

namespace {

CornerBreaking round(const ContourMove& a, const ContourMove& b, double r) {
  return break_corner(a, a.start, b, r, CornerShape::rounding);
}
CornerBreaking chamfer(const ContourMove& a, const ContourMove& b, double c) {
  return break_corner(a, a.start, b, c, CornerShape::legs);
}

}  // namespace

TEST_CASE("the ends of a chamfer are equally far from the corner") {
  const CornerBreaking found = chamfer(line({-20, 0}, {0, 0}), line({0, 0}, {0, 30}), 2);
  REQUIRE(found.why == Unbroken::no);
  check_point(found.corner.begin, {-2, 0});
  check_point(found.corner.end, {0, 2});
  CHECK_FALSE(found.corner.is_arc);
}

TEST_CASE("a chamfer given by its length has this length") {
  const ContourMove a = line({-20, 0}, {0, 0});
  const CornerBreaking square = break_corner(a, a.start, line({0, 0}, {0, 30}), std::sqrt(8.0), CornerShape::length);
  REQUIRE(square.why == Unbroken::no);
  check_point(square.corner.begin, {-2, 0});
  check_point(square.corner.end, {0, 2});
  const CornerBreaking sharp = break_corner(a, a.start, line({0, 0}, {-20, 20}), 3, CornerShape::length);
  CHECK((sharp.corner.end - sharp.corner.begin).length() == Approx(3));
  const ContourMove round = arc({0, 0}, {-20, 0}, {-10, 0}, true);
  CHECK(break_corner(a, a.start, round, 3, CornerShape::length).why == Unbroken::length_at_arc);
}

TEST_CASE("the leg of a chamfer on an arc is measured along the chord") {
  const CornerBreaking found = chamfer(line({0, 40}, {0, 10}), arc({0, 10}, {-10, 0}, {0, 0}, true), 10);
  REQUIRE(found.why == Unbroken::no);
  check_point(found.corner.end, {-10 * std::sin(std::numbers::pi / 3), 5});
  CHECK(chamfer(line({0, 40}, {0, 10}), arc({0, 10}, {-10, 0}, {0, 0}, true), 21).why == Unbroken::second_too_short);
}

TEST_CASE("a rounding touches both moves") {
  struct Row {
    const char* what;
    ContourMove a, b;
    double radius;
    Point2 center;
    bool is_ccw;
  };
  const std::vector<Row> rows{
      {"left", line({-20, 0}, {0, 0}), line({0, 0}, {0, 30}), 3, {-3, 3}, true},
      {"right", line({-20, 0}, {0, 0}), line({0, 0}, {0, -30}), 3, {-3, -3}, false},
      {"into a circle",
       line({-20, 0}, {0, 0}),
       arc({0, 0}, {-20, 0}, {-10, 0}, true),
       2,
       {-10 + std::sqrt(60.0), 2},
       true},
      {"out of a circle",
       arc({-20, 0}, {0, 0}, {-10, 0}, true),
       line({0, 0}, {-20, 0}),
       2,
       {-10 + std::sqrt(60.0), -2},
       true},
      {"round the outside of a circle",
       line({20, 0}, {0, 0}),
       arc({0, 0}, {-20, 0}, {-10, 0}, true),
       2,
       {-10 + std::sqrt(140.0), 2},
       false},
  };
  for (const Row& row : rows) {
    CAPTURE(row.what);
    const CornerBreaking found = round(row.a, row.b, row.radius);
    REQUIRE(found.why == Unbroken::no);
    check_point(found.corner.center, row.center);
    CHECK(found.corner.is_ccw == row.is_ccw);
    for (const Point2& end : {found.corner.begin, found.corner.end})
      CHECK((end - found.corner.center).length() == Approx(row.radius));
    const ContourMove first = between_corners(row.a, row.a.start, found.corner.begin);
    const ContourMove second = between_corners(row.b, found.corner.end, row.b.end);
    const ContourMove between = found.corner.move();
    check_point(first.direction_at_end(), between.direction_at_start());
    check_point(between.direction_at_end(), second.direction_at_start());
  }
}

TEST_CASE("a corner that cannot be broken names its reason") {
  const ContourMove a = line({-20, 0}, {0, 0});
  CHECK(round(a, line({0, 0}, {30, 0}), 1).why == Unbroken::straight_on);
  CHECK(round(a, line({0, 0}, {30, 0.5}), 1).why == Unbroken::straight_on);
  CHECK(round(a, line({0, 0}, {-30, 0}), 1).why == Unbroken::doubles_back);
  CHECK(chamfer(a, line({0, 0}, {0, 30}), 20).why == Unbroken::no);
  CHECK(chamfer(a, line({0, 0}, {0, 30}), 20.1).why == Unbroken::first_too_short);
  CHECK(chamfer(a, line({0, 0}, {0, 5}), 6).why == Unbroken::second_too_short);
  CHECK(round(a, line({0, 0}, {0, 30}), 1e300).why != Unbroken::no);
  CHECK(round(a, arc({0, 0}, {0, 4}, {0, 2}, true), 9).why != Unbroken::no);
  CHECK(break_corner(a, {-3, 0}, line({0, 0}, {0, 30}), 4, CornerShape::legs).why == Unbroken::first_too_short);
}

TEST_CASE("a line of which no length is left keeps its direction") {
  const ContourMove left = between_corners(line({0, 0}, {10, 0}), {0, 0}, {0, 0});
  check_point(left.direction_at_end(), {1, 0});
  check_point(left.end, {0, 0});
}
