#include "isogloss/cnc/coordinate_offset.hpp"

#include <catch2/catch.hpp>

#include "../../tests/support/fake_block.hpp"

using namespace ig::cnc;

using isogloss_test::FakeBlock;
using isogloss_test::FakeLink;

namespace {

struct Sections {
  FakeLink link;
  OffsetSection local{"LocalCoordinateOffset"};
  OffsetSection work{"CoordinateOffset"};
  FakeBlock fake;
  ig::Block block = fake.block();
};

}  // namespace

TEST_CASE("an offset that was never set is absent and reads as zero") {
  Sections s;
  CHECK(s.local.get(s.block) == ig::Vec3{0, 0, 0});
  CHECK_FALSE(s.local.has(s.block));
  CHECK(s.block.to_machine({1, 2, 3}) == ig::Vec3{1, 2, 3});
}

TEST_CASE("section and frame hold the same offset, and two sections add up") {
  Sections s;
  s.local.set(s.block, {10, 20, 5});
  s.work.set(s.block, {100, 0, -200});
  CHECK(s.local.get(s.block) == ig::Vec3{10, 20, 5});
  CHECK(s.block.to_machine({1, 2, 3}) == ig::Vec3{111, 22, -192});
  s.local.set(s.block, {});
  CHECK(s.local.has(s.block));
  CHECK(s.block.to_machine({1, 2, 3}) == ig::Vec3{101, 2, -197});
}

TEST_CASE("the frame is restored from the section") {
  Sections s;
  s.local.set(s.block, {10, 20, 5});
  s.fake.frames.clear();
  s.local.restore(s.block);
  CHECK(s.block.to_machine({0, 0, 0}) == ig::Vec3{10, 20, 5});
}
