#include "isogloss/cnc/event_to_steps.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

TEST_CASE("take() erases the whole section MotionEvent, and keeps the feed and the additional circles") {
  BlockDocument document;
  const auto event = document.member<EventToSteps>();
  ig::Block block = document.block();
  document.carry_name("MotionEvent.Form", "McArc");
  document.carry("MotionEvent.Feedrate_mmds", 12.5);
  document.carry_flag("MotionEvent.IsCcw");
  document.carry_count("MotionEvent.AdditionalCircleNum", 3);
  for (const char* axis : {"X", "Y", "Z"}) document.carry(std::string("MotionEvent.ArcCenter.") + axis, 1);
  const ToolSteps::Manner manner = event.take(block);
  CHECK_FALSE(manner.is_rapid);
  CHECK(manner.feed_mmds == 12.5);
  CHECK(manner.more_circles == 3);
  for (const char* field : {"Form", "IsRapid", "Feedrate_mmds", "IsCcw", "AdditionalCircleNum", "ArcCenter.X",
                            "ArcCenter.Y", "ArcCenter.Z"}) {
    CAPTURE(field);
    CHECK_FALSE(document.has(std::string("MotionEvent.") + field));
  }
}

TEST_CASE("take() of a rapid keeps that it is rapid, and of a move without a feed that it has none") {
  BlockDocument document;
  const auto event = document.member<EventToSteps>();
  ig::Block block = document.block();
  document.carry_name("MotionEvent.Form", "McLinear");
  document.carry_flag("MotionEvent.IsRapid");
  const ToolSteps::Manner manner = event.take(block);
  CHECK(manner.is_rapid);
  CHECK_FALSE(manner.feed_mmds.has_value());
  CHECK(manner.more_circles == 0);
  CHECK_FALSE(event.take(block).is_rapid);
}
