#include "isogloss/cnc/tool_steps.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

struct SteppedBlock {
  BlockDocument document;
  ToolSteps steps = document.member<ToolSteps>();
  ig::Block block = document.block();
};

}  // namespace

TEST_CASE("a step is rapid or has its feed, never both") {
  SteppedBlock s;
  s.steps.line(s.block, {1, 2, 3}, {.is_rapid = true, .feed_mmds = 5});
  s.steps.line(s.block, {4, 5, 6}, {.feed_mmds = 5});
  s.steps.line(s.block, {7, 8, 9}, {});
  REQUIRE(s.document.step_count() == 3);
  CHECK(s.document.step_name(0, "MotionEvent.Form") == "McLinear");
  CHECK(s.document.step(0, "ProgramXyz.Z") == 3);
  CHECK(s.document.step_integer(0, "MotionEvent.IsRapid") == 1);
  CHECK_FALSE(s.document.step_has(0, "MotionEvent.Feedrate_mmds"));
  CHECK_FALSE(s.document.step_has(1, "MotionEvent.IsRapid"));
  CHECK(s.document.step(1, "MotionEvent.Feedrate_mmds") == 5);
  CHECK_FALSE(s.document.step_has(2, "MotionEvent.Feedrate_mmds"));
}

TEST_CASE("an arc step has a centre, a sense and its additional circles") {
  SteppedBlock s;
  s.steps.arc(s.block, {1, 2, 3}, {4, 5, 3}, true, {.feed_mmds = 5, .more_circles = 2});
  CHECK(s.document.step_name(0, "MotionEvent.Form") == "McArc");
  CHECK(s.document.step(0, "MotionEvent.ArcCenter.X") == 4);
  CHECK(s.document.step(0, "MotionEvent.ArcCenter.Y") == 5);
  CHECK(s.document.step_integer(0, "MotionEvent.IsCcw") == 1);
  CHECK(s.document.step_integer(0, "MotionEvent.AdditionalCircleNum") == 2);
}

TEST_CASE("finish() maps every step to machine coordinates, and the last one turns the rotary axes") {
  SteppedBlock s;
  s.document.frame = {100, 0, -50};
  s.steps.line(s.block, {1, 2, 3}, {});
  s.steps.line(s.block, {4, 5, 6}, {});
  s.steps.finish(s.block, {4u, {0, 0, 90}});
  CHECK(s.document.step(0, "MachineCoordinate.X") == 101);
  CHECK(s.document.step(1, "MachineCoordinate.Z") == -44);
  CHECK_FALSE(s.document.step_has(0, "MachineCoordinate.C"));
  CHECK(s.document.step(1, "MachineCoordinate.C") == 90);
  CHECK_FALSE(s.document.step_has(1, "MachineCoordinate.A"));
}

TEST_CASE("a led step keeps the machine position and the angles of its caller") {
  SteppedBlock s;
  s.document.frame = {100, 0, 0};
  s.steps.led(s.block, {1, 2, 3}, {7, 8, 9}, {2u, {0, 30, 0}}, {.feed_mmds = 5});
  s.steps.finish(s.block, {});
  CHECK(s.document.step_name(0, "MotionEvent.Form") == "ClLinear");
  CHECK(s.document.step(0, "ProgramXyz.X") == 1);
  CHECK(s.document.step(0, "MachineCoordinate.X") == 7);
  CHECK(s.document.step(0, "MachineCoordinate.B") == 30);
  CHECK_FALSE(s.document.step_has(0, "MachineCoordinate.C"));
}
