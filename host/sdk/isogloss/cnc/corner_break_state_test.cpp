#include "isogloss/cnc/corner_break_state.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

struct CornerProgram {
  BlockDocument document;
  CornerBreakState state = document.member<CornerBreakState>(ig::read | ig::write);
  CornerBreakWords words = document.member<CornerBreakWords>();
  ig::Block block = document.block();
  CornerBreakState::Corner corner(CornerShape shape, double size) { return {document.symbol_of(",C"), shape, size}; }
  bool keeps_path_awake() { return document.has("CornerBreak.~Path"); }
  void next_block() {
    document.next_block();
    for (const char* field : {"Term", "Shape", "Size_mm", "IsModal", "~Path"})
      document.forget(std::string("CornerBreak.") + field);
    document.forget("MotionEvent.Form");
  }
};

}  // namespace

TEST_CASE("the section CornerBreak keeps the corner that was set") {
  for (const CornerShape shape : {CornerShape::legs, CornerShape::length, CornerShape::rounding}) {
    CornerProgram p;
    CHECK_FALSE(p.state.is_there(p.block));
    CHECK_FALSE(p.state.get(p.block).has_value());
    p.state.set(p.block, p.corner(shape, 2.5));
    CHECK(p.state.is_there(p.block));
    const auto corner = p.state.get(p.block);
    REQUIRE(corner.has_value());
    CHECK(p.document.text_of(corner->term) == ",C");
    CHECK(corner->shape == shape);
    CHECK(corner->size == 2.5);
    CHECK_FALSE(corner->is_modal);
  }
}

TEST_CASE("a corner that is set for every block is modal") {
  CornerProgram p;
  CornerBreakState::Corner corner = p.corner(CornerShape::rounding, 1);
  corner.is_modal = true;
  p.state.set(p.block, corner);
  CHECK(p.state.get(p.block)->is_modal);
}

TEST_CASE("from the block of a corner up to the next move the path syntaxes stay awake") {
  CornerProgram p;
  p.words.keep(p.block, p.corner(CornerShape::legs, 2));
  CHECK(p.state.is_there(p.block));
  CHECK(p.words.is_open(p.block));
  CHECK(p.keeps_path_awake());

  p.next_block();  // without a move
  p.words.keep(p.block, std::nullopt);
  CHECK(p.words.is_open(p.block));
  CHECK(p.keeps_path_awake());
  CHECK_FALSE(p.state.is_there(p.block));

  p.next_block();
  p.document.carry_name("MotionEvent.Form", "McLinear");
  p.words.keep(p.block, std::nullopt);
  CHECK_FALSE(p.words.is_open(p.block));
  CHECK(p.keeps_path_awake());

  p.next_block();
  p.words.keep(p.block, std::nullopt);
  CHECK_FALSE(p.keeps_path_awake());
}

TEST_CASE("a move that has a corner of its own leaves the corner open") {
  CornerProgram p;
  p.words.keep(p.block, p.corner(CornerShape::legs, 2));
  p.next_block();
  p.document.carry_name("MotionEvent.Form", "McLinear");
  p.words.keep(p.block, p.corner(CornerShape::rounding, 3));
  CHECK(p.words.is_open(p.block));
  CHECK(p.state.get(p.block)->size == 3);
}
