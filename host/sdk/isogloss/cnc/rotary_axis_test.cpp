#include "isogloss/cnc/rotary_axis.hpp"

#include <catch2/catch.hpp>

#include "../../tests/support/fake_block.hpp"

using namespace ig::cnc;

TEST_CASE("target() gives the angles at the end of the block before its words have become positions") {
  const isogloss_test::FakeLink link;
  const ig::Out<double> before{"nothing"};
  const RotaryAngles angles;
  const ig_field a = before.id() + 1, machine_a = a + 3;
  isogloss_test::FakeBlock block;
  ig::Block b = block.block();
  CHECK(angles.target(b).mask == 0);
  block.numbers[machine_a] = 30;
  CHECK(angles.target(b).mask == 1);
  CHECK(angles.target(b).value[0] == 30);
  block.numbers[a + 2] = -45;
  CHECK(angles.words(b).mask == 4);
  CHECK(angles.present(b).mask == 1);
  CHECK(angles.target(b).mask == 5);
  CHECK(angles.target(b).or_else({0, 7, 0}) == Angles{30, 7, -45});
}
