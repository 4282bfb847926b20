#include "isogloss/cnc/radius_compensation.hpp"

#include "isogloss/cnc/contour_test.hpp"

using namespace ig::cnc;

namespace {

constexpr double sqrt_half = 0.70710678118654752;

}  // namespace

// The worked example of the reference: radius 5, along X to the origin, then in another direction. Left is positive.
TEST_CASE("the angle between two straight moves decides how the tool passes their corner") {
  struct Row {
    const char* what;
    Point2 next;
    double offset;
    CornerKind kind;
    Point2 leave;
    std::vector<Point2> steps;
  };
  const std::vector<Row> rows{
      {"straight on", {10, 0}, 5, CornerKind::tangent, {0, 5}, {}},
      {"inner, left", {0, 10}, 5, CornerKind::inner, {-5, 5}, {}},
      {"outer of 90 degrees, left", {0, -10}, 5, CornerKind::obtuse, {5, 5}, {}},
      {"inner, right", {0, -10}, -5, CornerKind::inner, {-5, -5}, {}},
      {"outer of 90 degrees, right", {0, 10}, -5, CornerKind::obtuse, {5, -5}, {}},
      {"outer of 45 degrees", {10, -10}, 5, CornerKind::obtuse, {5 * (std::sqrt(2.0) - 1), 5}, {}},
      {"outer of 135 degrees", {-10, -10}, 5, CornerKind::acute, {5, 5}, {{10 * sqrt_half, 0}}},
      {"back on itself, left", {-10, 0}, 5, CornerKind::acute, {5, 5}, {{5, -5}}},
      {"back on itself, right", {-10, 0}, -5, CornerKind::acute, {5, -5}, {{5, 5}}},
      {"no offset", {0, 10}, 0, CornerKind::tangent, {0, 0}, {}},
  };
  for (const Row& row : rows) {
    CAPTURE(row.what);
    const Corner c = corner(line({-10, 0}, {0, 0}), line({0, 0}, row.next), row.offset, OuterCorner::lines);
    CHECK(c.kind == row.kind);
    check_point(c.leave, row.leave);
    REQUIRE(c.count == row.steps.size());
    for (std::size_t i = 0; i < c.count; ++i) check_point(c.steps[i].to, row.steps[i]);
  }
}

TEST_CASE("a way back along the same line goes round its end, whatever rounding makes of it") {
  for (const double rounding : {-1e-9, -1e-14, 0.0, 1e-14, 1e-9})
    for (const double offset : {5.0, -5.0}) {
      CAPTURE(rounding, offset);
      const Corner c = corner(line({-10, 0}, {0, 0}), line({0, 0}, {-10, rounding}), offset, OuterCorner::lines);
      CHECK(c.kind == CornerKind::acute);
      check_point(c.leave, {5, offset});
    }
}

TEST_CASE("an outer corner may be passed on an arc about it") {
  const Corner left = corner(line({-10, 0}, {0, 0}), line({0, 0}, {0, -10}), 5, OuterCorner::arc);
  CHECK(left.kind == CornerKind::round);
  check_point(left.leave, {0, 5});
  REQUIRE(left.count == 1);
  check_point(left.steps[0].to, {5, 0});
  CHECK(left.steps[0].is_arc);
  CHECK_FALSE(left.steps[0].is_ccw);
  const Corner right = corner(line({-10, 0}, {0, 0}), line({0, 0}, {0, 10}), -5, OuterCorner::arc);
  REQUIRE(right.count == 1);
  check_point(right.steps[0].to, {5, 0});
  CHECK(right.steps[0].is_ccw);
}

TEST_CASE("an arc is left where it ends, and entered where it begins") {
  // Counter-clockwise about (0,10) from the origin: outer corners are below, to the right.
  const ContourMove down = line({0, 10}, {0, 0}), turn = arc({0, 0}, {10, 10}, {0, 10}, true);
  const Corner in = corner(down, turn, -5, OuterCorner::lines);  // 90 degrees to the left, tool on the right
  CHECK(in.kind == CornerKind::obtuse);
  check_point(in.leave, {-5, -5});
  REQUIRE(in.count == 1);
  check_point(in.steps[0].to, {0, -5});
  const Corner out = corner(turn, line({10, 10}, {0, 10}), -5, OuterCorner::lines);
  CHECK(out.kind == CornerKind::obtuse);
  check_point(out.leave, {15, 10});
  REQUIRE(out.count == 1);
  check_point(out.steps[0].to, {15, 15});
  const Corner both = corner(arc({-10, 0}, {0, 0}, {-5, 0}, false), arc({0, 0}, {10, 0}, {5, 0}, false), 2,
                             OuterCorner::lines);  // down into the origin, then up: back on itself, tool on the left
  CHECK(both.kind == CornerKind::acute);
  check_point(both.leave, {2, 0});
  REQUIRE(both.count == 3);
  check_point(both.steps[0].to, {2, -2});
  check_point(both.steps[1].to, {-2, -2});
  check_point(both.steps[2].to, {-2, 0});
}

TEST_CASE("inner corners with arcs: the tool touches both") {
  const double offset = GENERATE(0.5, 2.0, 4.0);
  const ContourMove along = line({-20, 0}, {0, 0});
  const ContourMove arcs[] = {arc({0, 0}, {0, 20}, {0, 10}, true), arc({0, 0}, {10, 10}, {10, 0}, false),
                              arc({0, 0}, {-6, 12}, {-3, 6}, true)};
  for (const ContourMove& next : arcs) {
    const Corner c = corner(along, next, offset, OuterCorner::lines);
    if (cross(along.direction_at_end(), next.direction_at_start()) < 1e-9) continue;
    CHECK(c.kind == CornerKind::inner);
    CHECK(c.leave.v == Approx(offset));
    const double radius = (next.start - next.center).length();
    CHECK((c.leave - next.center).length() == Approx(radius + (next.is_ccw ? -offset : offset)));
    CHECK(along.way({-20, offset}, c.leave, offset) > 0);
  }
  const Corner two = corner(arcs[1], arc({10, 10}, {20, 20}, {20, 10}, false), offset, OuterCorner::lines);
  CHECK(two.kind == CornerKind::inner);
  CHECK((two.leave - Point2{10, 0}).length() == Approx(10 + offset));
  CHECK((two.leave - Point2{20, 10}).length() == Approx(10 + offset));
}

TEST_CASE("the corners at the ends of a move that is too short for the tool overlap") {
  const ContourMove groove = line({0, 0}, {0, 8});
  const Corner in = corner(line({-10, 0}, {0, 0}), groove, 5, OuterCorner::lines);
  const Corner out = corner(groove, line({0, 8}, {-10, 8}), 5, OuterCorner::lines);
  CHECK(groove.way(in.leave, out.leave, 5) == Approx(-2));
}

TEST_CASE("offsets that do not cross give no solution for a corner") {
  const ContourMove small = arc({0, 0}, {-2, 0}, {-1, 0}, true);
  const Corner c = corner(line({-10, 0}, {0, 0}), small, 3, OuterCorner::lines);
  CHECK(c.kind == CornerKind::no_solution);
  CHECK_FALSE(small.fits(3));
}

TEST_CASE("a change of side crosses the contour where the offsets cross, else by a step") {
  const Corner back = change_of_side(line({0, 0}, {10, 0}), 5, line({10, 0}, {0, 0}), -5);
  check_point(back.leave, {10, 5});
  CHECK(back.count == 0);
  const Corner across = change_of_side(line({0, 0}, {10, 0}), 2, line({10, 0}, {20, 0}), -2);
  check_point(across.leave, {10, 2});
  REQUIRE(across.count == 1);
  check_point(across.steps[0].to, {10, -2});
  const Corner turned = change_of_side(line({0, 0}, {10, 0}), 2, line({10, 0}, {10, 20}), -2);
  check_point(turned.leave, {10, 2});  // the point square to the corner; a step leads across from here
  REQUIRE(turned.count == 1);
  check_point(turned.steps[0].to, {12, 0});
}

TEST_CASE("a cancelling move with a direction ends beside the wall in that direction") {
  const Corner wall = directed_end(line({0, 0}, {20, 0}), 5, {0, 3});
  check_point(wall.leave, {15, 5});
  const Corner parallel = directed_end(line({0, 0}, {20, 0}), 5, {1, 0});
  CHECK(parallel.kind == CornerKind::square);
  check_point(parallel.leave, {20, 5});
}

TEST_CASE("an outer corner up to the limit is passed where the two offsets cross") {
  const ContourMove along = line({-10, 0}, {0, 0});
  const auto square = outer_crossing(along, line({0, 0}, {0, -10}), 5, 100);
  REQUIRE(square);
  CHECK(square->leave.u == Approx(5));
  CHECK(square->leave.v == Approx(5));
  CHECK_FALSE(outer_crossing(along, line({0, 0}, {0, -10}), 5, 89));
  CHECK(outer_crossing(along, line({0, 0}, {0, -10}), 5, 90));
  CHECK_FALSE(outer_crossing(along, line({0, 0}, {0, 10}), 5, 180));
  CHECK_FALSE(outer_crossing(along, line({0, 0}, {10, 0}), 5, 180));

  const ContourMove turn = arc({0, 0}, {5, 5}, {0, 5}, true);  // up at its end, with the tool on the right: outside
  const auto behind_arc = outer_crossing(turn, line({5, 5}, {0, 10}), -2, 100);
  REQUIRE(behind_arc);
  CHECK((behind_arc->leave - turn.center).length() == Approx(7));
  CHECK(behind_arc->leave.v > 5);
}

TEST_CASE("a tool behind the contour touches the circle about its first or last point") {
  const double offset = GENERATE(2.0, -2.0);
  const Point2 corner{1, 2}, tool{-20, -30};
  const auto onto = touching_move_from(tool, corner, offset);
  REQUIRE(onto);
  CHECK(is_same(onto->offset_start(offset), tool));
  CHECK((onto->offset_end(offset) - corner).length() == Approx(2));
  const auto off = touching_move_to(corner, tool, offset);
  REQUIRE(off);
  CHECK(is_same(off->offset_end(offset), tool));
  CHECK((off->offset_start(offset) - corner).length() == Approx(2));
  CHECK_FALSE(touching_move_from({2, 3}, corner, offset));
}
