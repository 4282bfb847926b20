#include "isogloss/cnc/peck_strokes.hpp"

#include <catch2/catch.hpp>

using namespace ig::cnc;

TEST_CASE("a last stroke that is shorter than the least stroke belongs to the stroke before it") {
  const double least = PeckStrokes::least_stroke;
  CHECK(PeckStrokes(0, -3 - least / 2, 1).number() == 3);
  CHECK(PeckStrokes(0, -3 - 2 * least, 1).number() == 4);
  CHECK(PeckStrokes(0, -3 - least / 2, 1).level(3, 3) == -3 - least / 2);
}

TEST_CASE("a hole without depth has one stroke, which stays at R") {
  const PeckStrokes flat(2, 2, 5);
  CHECK(flat.number() == 1);
  CHECK(flat.level(1, 1) == 2);
}

TEST_CASE("out of the hole is up below R, and down where the bottom lies above R") {
  CHECK(PeckStrokes(2, -20, 8).above(-6, 10) == 4);  // above R
  CHECK(PeckStrokes(-20, 2, 8).above(-12, 10) == -22);
}

TEST_CASE("upward strokes shrink as downward ones do") {
  const PeckStrokes up(0, 9, 4, 1, 1);  // 4 3 2
  REQUIRE(up.number() == 3);
  CHECK(up.level(1, 3) == 4);
  CHECK(up.level(2, 3) == 7);
  CHECK(up.level(3, 3) == 9);
}

TEST_CASE(
    "a first stroke that is not longer than the least one does not shrink, and all strokes have the least length") {
  const PeckStrokes even(0, -6, 2, 1, 2);
  REQUIRE(even.number() == 3);
  CHECK(even.level(1, 3) == -2);
  CHECK(even.level(2, 3) == -4);
}
