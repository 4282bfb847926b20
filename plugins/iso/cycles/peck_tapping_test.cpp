#include "cycles/peck_tapping.hpp"

#include <catch2/catch.hpp>

using iso::PeckTapping;

TEST_CASE("each cut of peck tapping is Q deep, and the last one ends at the bottom") {
  const PeckTapping pecks(5, -15, 8, 1, 100);
  REQUIRE(pecks.count == 3);
  CHECK(pecks.depth(1) == -3);
  CHECK(pecks.clearance(1) == -2);
  CHECK(pecks.depth(2) == -11);
  CHECK(pecks.clearance(2) == -10);
  CHECK(pecks.depth(3) == -15);
}

TEST_CASE("peck tapping works upwards too, and ignores the sign of Q") {
  const PeckTapping pecks(5, 15, -6, 1, 100);
  REQUIRE(pecks.count == 2);
  CHECK(pecks.depth(1) == 11);
  CHECK(pecks.clearance(1) == 10);
  CHECK(pecks.depth(2) == 15);
}

TEST_CASE("an exact multiple of Q leaves no rest, and a rest that is only rounding gets no cut") {
  CHECK(PeckTapping(2, -22, 8, 1, 100).count == 3);
  CHECK(PeckTapping(0, -0.3, 0.1, 1, 100).count == 3);
  CHECK(PeckTapping(0, -8 - 1e-9, 8, 1, 100).count == 1);
  CHECK(PeckTapping(0, -8.01, 8, 1, 100).count == 2);
  CHECK(PeckTapping(2, -22 - 1e-9, 8, 1, 100).depth(3) == -22 - 1e-9);
}

TEST_CASE("any Q gives a bounded number of cuts that ends at the bottom") {
  CHECK(PeckTapping(5, -15).count == 1);
  CHECK(PeckTapping(5, -15).depth(1) == -15);
  CHECK(PeckTapping(5, -15, 0, 1, 100).count == 1);
  CHECK(PeckTapping(5, 5, 8, 1, 100).count == 1);
  CHECK(PeckTapping(5, -15, 1e300, 1, 100).count == 1);
  for (const double q : {1e-300, 1e-9, 0.001}) {
    const PeckTapping pecks(5, -15, q, 1, 100);
    CHECK(pecks.count == 100);
    CHECK(pecks.is_cut_short);
    CHECK(pecks.depth(100) == -15);
  }
  CHECK(PeckTapping(1e300, -1e300, 8, 1, 100).is_cut_short);
  CHECK(PeckTapping(0, -100, 1, 1, 100).count == 100);
  CHECK_FALSE(PeckTapping(0, -100, 1, 1, 100).is_cut_short);
}
