#include "isogloss/cnc/tilt_transform.hpp"

#include <catch2/catch.hpp>

#include "../../tests/support/fake_block.hpp"

using namespace ig::cnc;

namespace {

void check(const ig::Vec3& is, const ig::Vec3& wanted) {
  CHECK(is.x == Approx(wanted.x).margin(1e-12));
  CHECK(is.y == Approx(wanted.y).margin(1e-12));
  CHECK(is.z == Approx(wanted.z).margin(1e-12));
}

}  // namespace

TEST_CASE("a rotation by 30 degrees about X20 Y10 gives the points of the manual") {
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

namespace {

ig::Vec3 row(const Mat4& m, std::size_t axis) { return {m[4 * axis], m[4 * axis + 1], m[4 * axis + 2]}; }

void check_is_rotation(const Mat4& m) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(scalar_product(row(m, i), row(m, k)) == Approx(i == k ? 1 : 0).margin(1e-15));
  check(vector_product(row(m, 0), row(m, 1)), row(m, 2));
}

}  // namespace

TEST_CASE("Euler angles give the reference's matrix, whose columns are the rows here") {
  const Mat4 m = euler_zxz({30, 45, 60});
  const double columns[3][3] = {
      {0.126826, 0.780330, 0.612372}, {-0.926777, -0.126826, 0.353553}, {0.353553, -0.612372, 0.707107}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) CHECK(m[4 * i + k] == Approx(columns[i][k]).margin(5e-7));
  check_is_rotation(m);
  CHECK(euler_zxz({0, 0, 0}) == identity_frame);
}

TEST_CASE("Euler angles give the reference's points") {
  check(mapped(at_origin(euler_zxz({0, 30, 0}), {10, 20, 50}), {5, 6, 2}),
        {15, 20 + 6 * std::sqrt(0.75) - 1, 50 + 3 + 2 * std::sqrt(0.75)});
  check(mapped(at_origin(euler_zxz({90, 30, 0}), {10, 20, 50}), {5, 6, 2}),
        {10 - 6 * std::sqrt(0.75) + 1, 25, 50 + 3 + 2 * std::sqrt(0.75)});
}

TEST_CASE("quarter turns are exact: I90 J90 lays Z along X, X along Y and Y along Z") {
  const Mat4 m = euler_zxz({90, 90, 0});
  CHECK(row(m, 0) == ig::Vec3{0, 1, 0});
  CHECK(row(m, 1) == ig::Vec3{0, 0, 1});
  CHECK(row(m, 2) == ig::Vec3{1, 0, 0});
}

TEST_CASE("roll, pitch and yaw turn in the given order about fixed axes, or about axes that turn along") {
  // X by 90: Y lies along Z. Then Z by 90, fixed: X goes to Y, and Z does not move.
  const Mat4 fixed = roll_pitch_yaw({90, 0, 90}, {0, 1, 2}, TurnedAxes::fixed);
  CHECK(row(fixed, 0) == ig::Vec3{0, 1, 0});
  CHECK(row(fixed, 1) == ig::Vec3{0, 0, 1});
  // The Z that was turned along points to -Y: X goes to the turned Y, which is Z.
  const Mat4 turned = roll_pitch_yaw({90, 0, 90}, {0, 1, 2}, TurnedAxes::turned);
  CHECK(row(turned, 0) == ig::Vec3{0, 0, 1});
  CHECK(row(turned, 1) == ig::Vec3{-1, 0, 0});
  const Mat4 forth = roll_pitch_yaw({11, 22, 33}, {0, 1, 2}, TurnedAxes::fixed);
  const Mat4 back = roll_pitch_yaw({11, 22, 33}, {2, 1, 0}, TurnedAxes::turned);
  for (std::size_t axis = 0; axis < 3; ++axis) check(row(forth, axis), row(back, axis));
  check_is_rotation(roll_pitch_yaw({11, 22, 33}, {1, 2, 0}, TurnedAxes::fixed));
}

TEST_CASE("axes from directions, of any length") {
  const auto m = from_x_and_side({0, 3, 0}, {-1e300, 1e300, 0});
  REQUIRE(m);
  CHECK(row(*m, 0) == ig::Vec3{0, 1, 0});
  CHECK(row(*m, 1) == ig::Vec3{-1, 0, 0});
  const auto upright = from_z_and_x({0, 0, 1e-300}, {1, 0, 1});
  REQUIRE(upright);
  CHECK(*upright == identity_frame);
  CHECK_FALSE(from_x_and_side({1, 0, 0}, {2, 0, 0}));
  CHECK_FALSE(from_x_and_side({1, 0, 0}, {-1, 1e-10, 0}));
  CHECK_FALSE(from_z_and_x({0, 0, 0}, {1, 0, 0}));
  CHECK_FALSE(from_z_and_x({HUGE_VAL, 0, 0}, {1, 0, 0}));
  for (const double k : {-2.0, 0.1, 5.0}) check_is_rotation(from_x_and_side({1, k, 2}, {0.3, -1, k}).value());
}

TEST_CASE("projection angles: X seen from the side, Y seen along X") {
  const auto m = from_projections({30, 0, 0});
  REQUIRE(m);
  check(row(*m, 0), {std::sqrt(0.75), 0, -0.5});
  check(row(*m, 2), {0.5, 0, std::sqrt(0.75)});
  const auto both = from_projections({45, 45, 90});
  REQUIRE(both);
  check(row(*both, 2), {std::sqrt(1.0 / 3), -std::sqrt(1.0 / 3), std::sqrt(1.0 / 3)});
  check(row(*both, 1), {-std::sqrt(0.5), 0, std::sqrt(0.5)});  // X', a quarter turn on
  check_is_rotation(*both);
  CHECK_FALSE(from_projections({90, 90, 0}));
}

TEST_CASE("a product applies one plane inside another, and the inverse leads back") {
  const Mat4 outer = at_origin(euler_zxz({90, 90, 0}), {10, 20, 30}), inner = at_origin(turn_about(2, 90), {1, 2, 3});
  const Mat4 both = product(inner, outer);
  CHECK(mapped(both, {5, 0, 0}) == mapped(outer, mapped(inner, {5, 0, 0})));
  CHECK(mapped(both, {5, 0, 0}) == ig::Vec3{13, 21, 37});
  check(mapped(inverse(both), {13, 21, 37}), {5, 0, 0});
  CHECK(inverse(identity_frame) == identity_frame);
}

TEST_CASE("a rotation about infinity is not finite") {
  CHECK(is_finite(identity_frame));
  CHECK_FALSE(is_finite(rotation_in(xy_plane, 180, {1.5e308, 0, 0}, {1.5e308, 0, 0})));
}

TEST_CASE("the entry of a block is the identity until it is set") {
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
