#include "isogloss/cnc/plane.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/program_xyz.hpp"

using namespace ig::cnc;

TEST_CASE("first × second = tool in every plane") {
  for (const PlaneAxes& plane : {xy_plane, zx_plane, yz_plane}) {
    CAPTURE(plane.tool);
    CHECK((plane.first + 1) % 3 == plane.second);
    CHECK((plane.second + 1) % 3 == plane.tool);
  }
}

TEST_CASE("at_level() changes only the position on the tool axis") {
  const ig::Vec3 hole{30, 20, 50};
  CHECK(xy_plane.at_level(hole, 2) == ig::Vec3{30, 20, 2});
  CHECK(zx_plane.at_level(hole, 2) == ig::Vec3{30, 2, 50});
  CHECK(yz_plane.at_level(hole, 2) == ig::Vec3{2, 20, 50});
}

TEST_CASE("program points lose the noise of an inverted frame") {
  CHECK(rounded(25.190799999999996) == 25.1908);
  CHECK(rounded(-1e-12) == 0);
  CHECK_FALSE(std::signbit(rounded(-1e-12)));
  CHECK(rounded(1e300) == 1e300);
  CHECK(rounded(ig::Vec3{0.1 + 0.2, -5, 1e6 + 1e-10}) == ig::Vec3{0.3, -5, 1e6});
}
