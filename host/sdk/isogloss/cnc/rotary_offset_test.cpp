#include "isogloss/cnc/rotary_offset.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "isogloss/cnc/block_document_test.hpp"

using ig::cnc::Rollover;
using ig::cnc::RotaryOffsets;

TEST_CASE("the offset is added to the word") {
  for (const Rollover rollover : {Rollover::counts_on, Rollover::shortest}) {
    CHECK(RotaryOffsets::to_machine(350, 30, rollover) == 380);
    CHECK(RotaryOffsets::to_machine(-10, 30, rollover) == 20);
  }
}

TEST_CASE("without an offset the word is the angle") {
  for (const Rollover rollover : {Rollover::counts_on, Rollover::shortest, Rollover::signed_direction}) {
    CHECK(RotaryOffsets::to_machine(725, 0, rollover) == 725);
    CHECK(RotaryOffsets::to_machine(-725, 0, rollover) == -725);
  }
}

TEST_CASE("a sign that is a direction is kept, and the position is shifted by the offset") {
  for (const double word : {0.0, 10.0, -10.0, 350.0, -350.0, 359.5, -330.0, 330.0, 1000.0, -1000.0})
    for (const double offset : {30.0, -30.0, 400.0, -1000.0, 359.5, -359.5}) {
      INFO(word << " with " << offset);
      const double machine = RotaryOffsets::to_machine(word, offset, Rollover::signed_direction);
      CHECK((machine < 0) == (word < 0));
      CHECK(std::fabs(std::remainder(std::fabs(machine) - std::fabs(word) - offset, 360)) < 1e-9);
    }
}

TEST_CASE("an offset acts on the axes that the machine has") {
  struct AxesBC {
    bool has(std::size_t axis) const { return axis != 0; }
  };
  isogloss_test::BlockDocument document;
  const auto section = document.member<ig::cnc::RotaryOffsetSection>("CoordinateOffset");
  ig::Block block = document.block();
  CHECK_FALSE(section.acts_on(block, AxesBC{}));
  section.set(block, {30, 0, 0});
  CHECK_FALSE(section.acts_on(block, AxesBC{}));
  section.set(block, {30, 0, -90});
  CHECK(section.acts_on(block, AxesBC{}));
}
