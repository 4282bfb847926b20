#include "isogloss/cnc/degrees.hpp"

#include <catch2/catch.hpp>

using namespace ig::cnc;

TEST_CASE("answers of one digit are exact, in each turn") {
  for (const double turn : {-720.0, -360.0, 0.0, 360.0, 36000.0}) {
    CAPTURE(turn);
    CHECK(sine(turn + 30) == 0.5);
    CHECK(sine(turn + 150) == 0.5);
    CHECK(sine(turn - 30) == -0.5);
    CHECK(sine(turn + 210) == -0.5);
    CHECK(sine(turn + 90) == 1);
    CHECK(sine(turn + 270) == -1);
    CHECK(sine(turn + 180) == 0);
    CHECK(cosine(turn + 60) == 0.5);
    CHECK(cosine(turn - 60) == 0.5);
    CHECK(cosine(turn + 120) == -0.5);
    CHECK(cosine(turn + 90) == 0);
    CHECK(cosine(turn + 180) == -1);
    CHECK(cosine(turn) == 1);
    CHECK(tangent(turn + 45) == 1);
    CHECK(tangent(turn - 45) == -1);
    CHECK(tangent(turn + 135) == -1);
    CHECK(tangent(turn + 225) == 1);
    CHECK(tangent(turn) == 0);
    CHECK(std::isnan(tangent(turn + 90)));
    CHECK(std::isnan(tangent(turn - 90)));
  }
}

TEST_CASE("whole angles of a sine and a cosine are exact") {
  CHECK(arc_sine(0.5) == 30);
  CHECK(arc_sine(-0.5) == -30);
  CHECK(arc_sine(1) == 90);
  CHECK(arc_sine(-1) == -90);
  CHECK(arc_sine(0) == 0);
  CHECK(arc_cosine(0.5) == 60);
  CHECK(arc_cosine(-0.5) == 120);
  CHECK(arc_cosine(1) == 0);
  CHECK(arc_cosine(-1) == 180);
  CHECK(arc_cosine(0) == 90);
  CHECK(arc_sine(0.3) == std::asin(0.3) * degrees_per_radian);
  CHECK(arc_cosine(0.3) == std::acos(0.3) * degrees_per_radian);
  CHECK(std::isnan(arc_sine(1.001)));
  CHECK(std::isnan(arc_cosine(-1.001)));
}

TEST_CASE("other angles are those of the C++ library") {
  CHECK(sine(10) == std::sin(10 * radians_per_degree));
  CHECK(cosine(370) == std::cos(10 * radians_per_degree));
  CHECK(tangent(190) == std::tan(10 * radians_per_degree));
  CHECK(std::isnan(sine(std::numeric_limits<double>::infinity())));
}
