#include "isogloss/cnc/contour_move.hpp"

#include "isogloss/cnc/contour_test.hpp"

using namespace ig::cnc;

TEST_CASE("the tool's centre is beside the start and the end of a move, on the side of the offset") {
  const ContourMove along = line({0, 0}, {10, 0});
  check_point(along.offset_start(2), {0, 2});
  check_point(along.offset_end(-2), {10, -2});
  const ContourMove quarter = arc({10, 0}, {0, 10}, {0, 0}, true);
  check_point(quarter.direction_at_start(), {0, 1});
  check_point(quarter.direction_at_end(), {-1, 0});
  check_point(quarter.offset_start(2), {8, 0});
  check_point(quarter.offset_end(-2), {0, 12});
}

TEST_CASE("the way along a move is negative where the corners at its ends overlap") {
  CHECK(line({0, 0}, {0, 8}).way({-5, 5}, {-5, 3}, 5) == Approx(-2));
  const ContourMove circle = arc({10, 0}, {10, 0}, {0, 0}, true);
  CHECK(circle.way({5, 0}, {5, 0}, 5) == Approx(2 * std::numbers::pi * 5));
}

TEST_CASE("the tool fits into an arc of at least its radius, and always round one") {
  const ContourMove circle = arc({10, 0}, {10, 0}, {0, 0}, true);
  CHECK(circle.fits(5));
  CHECK(circle.fits(10));
  CHECK_FALSE(circle.fits(10.001));
  CHECK(circle.fits(-10));
}
