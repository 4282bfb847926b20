#include "isogloss/cnc/tool_direction.hpp"

#include <limits>

#include "isogloss/cnc/five_axis_test.hpp"

using namespace ig::cnc;

TEST_CASE("a head turns the tool in the machine, a table does not") {
  const HeadAndTable machine;
  const FiveAxisProgram p(machine);
  const auto direction = tool_direction(p.kinematics, {0, 30, -75});
  REQUIRE(direction.has_value());
  CHECK((*direction)[0] == Approx(0.5));
  CHECK((*direction)[1] == Approx(0).margin(1e-12));
  CHECK((*direction)[2] == Approx(0.8660254037844387));
}

TEST_CASE("angles that are no numbers have no direction") {
  const HeadAndTable machine;
  const FiveAxisProgram p(machine);
  CHECK_FALSE(tool_direction(p.kinematics, {0, std::numeric_limits<double>::quiet_NaN(), 0}).has_value());
}
