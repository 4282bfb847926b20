#include "isogloss/cnc/cycle_in_force.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

TEST_CASE("a canned cycle is in force from its call to the code that ends it") {
  BlockDocument document;
  const auto cycle = document.member<CycleInForce>();
  const ig::Block block = document.block();
  CHECK_FALSE(cycle.is_on(block));
  document.carry_name("CannedCycle.Term", "G81");
  CHECK(cycle.is_on(block));
  document.carry_name("CannedCycle.Term", "G80");
  CHECK_FALSE(cycle.is_on(block));
}

TEST_CASE("a canned cycle is no longer in force in the block that ends it") {
  for (const char* code : {"G00", "G01", "G02", "G03", "G33", "G80"}) {
    CAPTURE(code);
    BlockDocument document;
    const auto cycle = document.member<CycleInForce>();
    document.carry_name("CannedCycle.Term", "G81");
    document.put_code(std::string("Parsing.Flags.") + code);
    CHECK_FALSE(cycle.is_on(document.block()));
  }
}
