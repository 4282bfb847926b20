#include "isogloss/cnc/cycle_spindle.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

constexpr const char* spindle_direction = "SpindleSpeed.Direction";

struct SpindleCycle {
  BlockDocument document;
  CycleSpindle spindle = document.member<CycleSpindle>();
  ig::CompoundMotion motion = document.member<ig::CompoundMotion>();
  ig::Block block = document.block();
  /// M03, M04 or M05 in the block of the cycle.
  void program(ig::Spindle direction) {
    block.set(document.member<ig::Out<ig::Symbol>>(spindle_direction), spindle.name(direction));
  }
};

}  // namespace

TEST_CASE("a cycle leaves the spindle alone where no block has set a direction") {
  SpindleCycle c;
  c.spindle.begin(c.block, c.motion, ig::Spindle::cw);
  CHECK(c.document.step_count() == 0);
  CHECK_FALSE(c.spindle.direction(c.block).has_value());
}

TEST_CASE("a direction of an earlier block gives way to the direction that the cycle ends with, without a step") {
  SpindleCycle c;
  c.document.carry_name(spindle_direction, "CCW");
  c.spindle.begin(c.block, c.motion, ig::Spindle::cw);
  CHECK(c.document.step_count() == 0);
  CHECK(c.document.name(spindle_direction) == "CW");
  CHECK_FALSE(c.document.is_fresh(spindle_direction));
}

TEST_CASE("an M code of the block that the cycle reverses becomes the first step") {
  for (const auto& [now, name] : {std::pair{ig::Spindle::ccw, "CCW"}, std::pair{ig::Spindle::stop, "STOP"}}) {
    SpindleCycle c;
    c.program(now);
    c.spindle.begin(c.block, c.motion, ig::Spindle::cw);
    REQUIRE(c.document.step_count() == 1);
    CHECK(c.document.step_name(0, "SpindleControl.Direction") == name);
    CHECK(c.document.name(spindle_direction) == "CW");
    CHECK_FALSE(c.document.is_fresh(spindle_direction));
  }
}

TEST_CASE("a start that the cycle keeps needs no step, because it acts before the steps of the block") {
  SpindleCycle c;
  c.program(ig::Spindle::cw);
  c.spindle.begin(c.block, c.motion, ig::Spindle::cw);
  CHECK(c.document.step_count() == 0);
  CHECK(c.document.is_fresh(spindle_direction));
}

TEST_CASE("a stop becomes the first step although the cycle keeps it, because it would act after the steps") {
  SpindleCycle c;
  c.program(ig::Spindle::stop);
  c.spindle.begin(c.block, c.motion, ig::Spindle::stop);
  REQUIRE(c.document.step_count() == 1);
  CHECK(c.document.step_name(0, "SpindleControl.Direction") == "STOP");
  CHECK(c.document.name(spindle_direction) == "STOP");
}
