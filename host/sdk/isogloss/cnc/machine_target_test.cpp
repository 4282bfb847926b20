#include "isogloss/cnc/machine_target.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

struct TargetMembers {
  LastProgramXyz last;
  ig::Xyz machine{"MachineCoordinate", ig::read | ig::write};
  ig::Xyz program{"ProgramXyz", ig::write};
};

/// The block before ended at program point 10,20,5; the frame shifts X by 100. No machine position is known.
struct ShiftedDocument : BlockDocument {
  TargetMembers members = member<TargetMembers>();
  ig::Block now = block();
  ShiftedDocument() {
    frame = {100, 0, 0};
    carry("previous ProgramXyz.X", 10);
    carry("previous ProgramXyz.Y", 20);
    carry("previous ProgramXyz.Z", 5);
  }
  ig::Vec3 position() { return machine_position(now, members.machine, members.last); }
  bool move_to(const ig::Vec3& to) { return set_machine_target(now, members.machine, members.program, to); }
};

}  // namespace

TEST_CASE("without a machine position, the program point gives it") {
  ShiftedDocument d;
  CHECK(d.position() == ig::Vec3{110, 20, 5});
}

TEST_CASE("a machine target is in force at once, and the program point belongs to it") {
  ShiftedDocument d;
  CHECK(d.move_to({150, 2, 3}));
  CHECK(d.position() == ig::Vec3{150, 2, 3});
  CHECK(d.number("ProgramXyz.X") == 50);
  CHECK(d.number("ProgramXyz.Y") == 2);
}

TEST_CASE("a frame without an inverse keeps the program point") {
  ShiftedDocument d;
  d.frame_has_inverse = false;
  CHECK_FALSE(d.move_to({150, 2, 3}));
  CHECK_FALSE(d.has("ProgramXyz.X"));
  CHECK(d.number("MachineCoordinate.X") == 150);
}
