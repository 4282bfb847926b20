#include "tilt_transform_util.hpp"

#include <catch2/catch.hpp>

#include "../../tests/support/fake_block.hpp"

using namespace iso;

namespace {

void check(const ig::Vec3& is, const ig::Vec3& wanted) {
  CHECK(is.x == Approx(wanted.x).margin(1e-12));
  CHECK(is.y == Approx(wanted.y).margin(1e-12));
  CHECK(is.z == Approx(wanted.z).margin(1e-12));
}

}  // namespace

TEST_CASE("the manual's points: 30 degrees about X20 Y10") {
  const ig::Vec3 center{20, 10, 0};
  const Mat4 m = rotation_in(xy_plane, 30, center, center);
  check(mapped(m, {50, 10, 7}), {20 + 30 * std::sqrt(0.75), 25, 7});
  check(mapped(m, {50, 40, 7}), {5 + 30 * std::sqrt(0.75), 25 + 30 * std::sqrt(0.75), 7});
  check(mapped(m, center), center);
}

TEST_CASE("a quarter turn takes the first axis to the second, exactly, in every plane") {
  for (const PlaneAxes& plane : {xy_plane, zx_plane, yz_plane}) {
    CAPTURE(plane.tool);
    ig::Vec3 first, second, tool;
    first[plane.first] = second[plane.second] = tool[plane.tool] = 1;
    const Mat4 m = rotation_in(plane, 90, {}, {});
    CHECK(mapped(m, first) == second);
    CHECK(mapped(m, second) == -1.0 * first);
    CHECK(mapped(m, tool) == tool);
    CHECK(rotation_in(plane, 450, {}, {}) == m);
    CHECK(rotation_in(plane, -270, {}, {}) == m);
  }
}

TEST_CASE("turns of 0, 180 and 360 degrees are exact") {
  CHECK(rotation_in(xy_plane, 0, {1, 2, 3}, {1, 2, 3}) == identity_frame);
  CHECK(rotation_in(zx_plane, 360, {1, 2, 3}, {1, 2, 3}) == identity_frame);
  CHECK(mapped(rotation_in(xy_plane, -180, {1, 0, 0}, {1, 0, 0}), {3, 5, 7}) == ig::Vec3{-1, -5, 7});
}

TEST_CASE("a rotation that takes one point to another keeps distances from it") {
  const Mat4 m = rotation_in(yz_plane, 33, {1, 2, 3}, {9, -4, 6});
  check(mapped(m, {1, 2, 3}), {1, -4, 6});  // the tool axis keeps its position
  const ig::Vec3 moved = mapped(m, {1, 5, 7}) - ig::Vec3{1, -4, 6};
  CHECK(std::hypot(moved.y, moved.z) == Approx(5));
}

TEST_CASE("a rotation about infinity is not finite") {
  CHECK(is_finite(identity_frame));
  CHECK_FALSE(is_finite(rotation_in(xy_plane, 180, {1.5e308, 0, 0}, {1.5e308, 0, 0})));
}

TEST_CASE("the entry of a block: identity until somebody sets it") {
  const isogloss_test::FakeLink link;
  const TiltFrame frame(ig::read | ig::write);
  isogloss_test::FakeBlock fake;
  ig::Block block = fake.block();
  CHECK(frame.get(block) == identity_frame);
  const Mat4 turned = rotation_in(xy_plane, 90, {1, 0, 0}, {1, 0, 0});
  frame.set(block, turned);
  CHECK(frame.get(block) == turned);
  CHECK(block.to_machine({2, 0, 0}) == ig::Vec3{1, 1, 0});
}
