#include "isogloss/cnc/program_xyz.hpp"

#include <catch2/catch.hpp>

#include "../../tests/support/fake_block.hpp"

using namespace ig::cnc;

using isogloss_test::FakeBlock;
using isogloss_test::FakeLink;

namespace {

/// The block before ended at program point 10,20,5 and machine point 110,20,5; its frame shifts X by 100.
struct Resting {
  FakeLink link;
  LastProgramXyz last;  // previous values: ids 0 to 2 are ProgramXyz, 3 to 5 MachineCoordinate
  ig::Transform frame{"CoordinateOffset"};
  FakeBlock fake;
  ig::Block block = fake.block();
  Resting() {
    fake.numbers = {{0, 10}, {1, 20}, {2, 5}, {3, 110}, {4, 20}, {5, 5}};
    block.set_translation(frame, {100, 0, 0});
    fake.frame_changed = false;
  }
};

}  // namespace

TEST_CASE("while the frame does not change, the block begins at the carried point") {
  Resting r;
  CHECK(r.last(r.block) == ig::Vec3{10, 20, 5});
  r.fake.numbers[0] = 10.000000001;  // a point mapped back would have this noise
  CHECK(r.last(r.block).x == 10.000000001);
}

TEST_CASE("a frame that changes under a resting spindle gives the tool another program point") {
  Resting r;
  r.block.set_translation(r.frame, {300, -1, 0});
  CHECK(r.last(r.block) == ig::Vec3{-190, 21, 5});
  CHECK(r.last.of_resting_machine(r.block) == ig::Vec3{-190, 21, 5});
  CHECK(r.block.to_machine(r.last(r.block)) == ig::Vec3{110, 20, 5});
}

TEST_CASE("the tip that rests in the workpiece keeps its program point, whatever the frame is") {
  Resting r;
  r.block.set_translation(r.frame, {300, -1, 0});
  CHECK(r.last.as_carried(r.block) == ig::Vec3{10, 20, 5});
}

TEST_CASE("a point survives the way through a rotated frame and back") {
  Resting r;
  const double quarter[16] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1};
  r.fake.host()->set_transform(r.block.raw(), r.frame.id(), quarter);
  CHECK(r.last(r.block) == ig::Vec3{18, -109, 2});
  CHECK(r.block.to_machine({18, -109, 2}) == ig::Vec3{110, 20, 5});
}

TEST_CASE("without a machine point the carried point is used, and without both 0,0,0") {
  Resting r;
  r.fake.numbers.erase(4);
  r.block.set_translation(r.frame, {300, 0, 0});
  CHECK(r.last.of_resting_machine(r.block) == std::nullopt);
  CHECK(r.last(r.block) == ig::Vec3{10, 20, 5});
  r.fake.numbers.clear();
  CHECK(r.last(r.block) == ig::Vec3{0, 0, 0});
}

TEST_CASE("rounding does not change numbers too large for it") {
  CHECK(rounded(1e300) == 1e300);
  CHECK(rounded(-1e10) == -1e10);
  CHECK(rounded(8999999.1234567891) == Approx(8999999.1234567891).epsilon(1e-15));
}
