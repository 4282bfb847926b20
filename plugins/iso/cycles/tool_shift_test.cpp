#include "cycles/tool_shift.hpp"

#include <catch2/catch.hpp>

using namespace iso;

TEST_CASE("the shift has the directions of parameter 5101 in all three planes") {
  struct Row {
    ShiftDirection direction;
    ig::Vec3 g17, g18, g19;
  };
  const Row row = GENERATE(Row{ShiftDirection::plus_x, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                           Row{ShiftDirection::minus_x, {-1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                           Row{ShiftDirection::plus_y, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                           Row{ShiftDirection::minus_y, {0, -1, 0}, {-1, 0, 0}, {0, 0, -1}});
  CHECK(shift_direction(row.direction, xy_plane) == row.g17);
  CHECK(shift_direction(row.direction, zx_plane) == row.g18);
  CHECK(shift_direction(row.direction, yz_plane) == row.g19);
}

TEST_CASE("a signed axis number gives a direction of the plane, or none") {
  CHECK(shift_direction(1, xy_plane) == ig::Vec3{1, 0, 0});
  CHECK(shift_direction(-2, xy_plane) == ig::Vec3{0, -1, 0});
  CHECK(shift_direction(3, zx_plane) == ig::Vec3{0, 0, 1});
  CHECK(shift_direction(-3, yz_plane) == ig::Vec3{0, 0, -1});
  for (const double none : {0.0, 3.0, -3.0, 4.0, 1.5, 1e300}) CHECK_FALSE(shift_direction(none, xy_plane).has_value());
  CHECK_FALSE(shift_direction(2, zx_plane).has_value());
  CHECK_FALSE(shift_direction(-1, yz_plane).has_value());
}

TEST_CASE("a shifted bore keeps its levels") {
  const CycleHole hole{xy_plane, {30, 20, 0}, 50};
  const CycleHole aside = shifted(hole, {0, -0.5, 0});
  CHECK(aside.at(-18) == ig::Vec3{30, 19.5, -18});
  CHECK(aside.approach_level == 50);
}
