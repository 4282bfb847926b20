#include "isogloss/cnc/cycle_letters.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

TEST_CASE("K of a canned cycle is a count unless the option says that it is a length") {
  BlockDocument document;
  CHECK_FALSE(document.member<CycleK>().is_length());
  document.options["cycle-k"] = "length";
  CHECK(document.member<CycleK>().is_length());
}

TEST_CASE("J of a block without a code is a ratio only while a tapping cycle is active, and only by the option") {
  BlockDocument document;
  const auto length = document.member<TappingJ>();
  document.options["tapping-j"] = "ratio";
  const auto ratio = document.member<TappingJ>();
  const ig::Block block = document.block();
  CHECK_FALSE(length.is_ratio());
  CHECK(ratio.is_ratio());
  CHECK_FALSE(ratio.is_ratio(block));
  for (const std::string_view cycle : TappingJ::cycles) {
    document.carry_name("CannedCycle.Term", cycle);
    CHECK(ratio.is_ratio(block));
    CHECK_FALSE(length.is_ratio(block));
  }
  document.carry_name("CannedCycle.Term", "G81");
  CHECK_FALSE(ratio.is_ratio(block));
}
