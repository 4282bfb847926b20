#include "isogloss/cnc/units.hpp"

#include <catch2/catch.hpp>

using namespace ig::cnc;

TEST_CASE("a factor of units gives the unit that its name begins with") {
  CHECK(2 * mm_per_inch == 50.8);
  CHECK(180 * radians_per_degree == std::numbers::pi);
  CHECK(std::numbers::pi * degrees_per_radian == 180);
  CHECK(radians_per_degree * degrees_per_radian == Approx(1).epsilon(1e-15));
}
