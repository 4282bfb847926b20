#include "isogloss/cnc/rotary_angle.hpp"

#include <catch2/catch.hpp>

using namespace ig::cnc;

TEST_CASE("the shortest way: the reference's examples") {
  CHECK(nearest_turn(350, 10) == 370);
  CHECK(nearest_turn(10, 350) == -10);
  CHECK(nearest_turn(725, 0) == 720);
  CHECK(nearest_turn(0, 270) == -90);
  CHECK(nearest_turn(90, -90) == 270);
  CHECK(nearest_turn(90, -90, HalfTurn::negative) == -90);
  CHECK(nearest_turn(0, 180) == 180);
  CHECK(nearest_turn(0, 180, HalfTurn::negative) == -180);
  CHECK(nearest_turn(0.1, 180.1) == 180.1);
  CHECK(nearest_turn(0.1, 0.3) == 0.3);
  CHECK_FALSE(std::signbit(nearest_turn(-360, 0) + 360));
}

TEST_CASE("the shortest way is never more than half a turn, and ends where it was sent") {
  for (double from = -1000; from <= 1000; from += 37)
    for (double to = -1000; to <= 1000; to += 41) {
      const double end = nearest_turn(from, to);
      CAPTURE(from, to);
      CHECK(std::fabs(end - from) <= 180);
      CHECK(std::remainder(end - to, 360) == 0);
    }
}

TEST_CASE("angles too large to be a position on the circle give finite results") {
  for (const double wild : {1e300, -1e300, 1.7e308, -1.7e308, 1e10}) {
    CHECK(std::isfinite(nearest_turn(wild, -wild)));
    CHECK(std::isfinite(directed_turn(-wild, wild)));
    CHECK(std::fabs(nearest_turn(0, wild)) <= 180);
  }
}

TEST_CASE("with a signed direction the sign of a word is the direction of rotation") {
  CHECK(directed_turn(0, 90) == 90);
  CHECK(directed_turn(0, -90) == -270);  // to position 90, backwards
  CHECK(directed_turn(90, 30) == 390);
  CHECK(directed_turn(90, -30) == 30);
  CHECK(directed_turn(350, 10) == 370);
  CHECK(directed_turn(350, -10) == 10);
  CHECK(directed_turn(30, 0) == 360);
  CHECK(directed_turn(30, -0.0) == 360);  // 0 cannot carry a sign
  CHECK(directed_turn(30, 30) == 30);     // already there: no turn
  CHECK(directed_turn(30, -30) == 30);
  CHECK(directed_turn(750, -30) == 750);
}

TEST_CASE("a turn inside the travel is preferred, even where it is the longer one") {
  const AngleRange travel{-120, 300};
  CHECK(nearest_turn_inside(290, 10, travel, HalfTurn::positive) == 10);
  CHECK(nearest_turn_inside(-100, 200, travel, HalfTurn::positive) == 200);
  CHECK(nearest_turn_inside(0, 90, travel, HalfTurn::positive) == 90);
  CHECK(nearest_turn_inside(0, 180, {-10, 10}, HalfTurn::positive) == 180);  // none is inside; reported later
  CHECK(AngleRange{0, 90}.holds(90 + 1e-7));
  CHECK_FALSE(AngleRange{0, 90}.holds(90 + 2e-6));
}
