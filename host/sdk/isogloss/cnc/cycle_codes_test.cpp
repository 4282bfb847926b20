#include "isogloss/cnc/cycle_codes.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

/// A chain in which another plugin declares the canned cycle G12 with X alone.
CycleCalls calls_beside_g12(BlockDocument& document) {
  document.matches = {{"Parsing.*{canned-cycle}", {"Parsing.G81", "Parsing.G12"}},
                      {"Parsing.*{canned-cycle}.X", {"Parsing.G12.X", "Parsing.G81.X"}}};
  return document.create([] { return CycleCalls("X R", ig::read | ig::wake, {"G80"}); });
}

}  // namespace

TEST_CASE("the rows of a CycleCalls are its own codes, those of group 09, and each code of another plugin once") {
  BlockDocument document;
  const CycleCalls calls = calls_beside_g12(document);
  REQUIRE(calls.code_count() == 1 + cycle_codes.size() + 1);
  CHECK(document.text_of(calls.name(0)) == "G80");
  for (std::size_t i = 0; i < cycle_codes.size(); ++i) CHECK(document.text_of(calls.name(1 + i)) == cycle_codes[i]);
  CHECK(document.text_of(calls.name(14)) == "G12");
  CHECK(calls.code(14) == document.id("Parsing.G12"));
}

TEST_CASE("a code of another plugin has the words that its plugin declares, and no others") {
  BlockDocument document;
  const CycleCalls calls = calls_beside_g12(document);
  CHECK(calls.word(14, 'X') == document.id("Parsing.G12.X"));
  CHECK(calls.word(14, 'R') == IG_NO_FIELD);
  CHECK(calls.word(1, 'R') == document.id("Parsing.G73.R"));
}

TEST_CASE("without other plugins a CycleCalls holds group 09") {
  BlockDocument document;
  const auto calls = document.create([] { return CycleCalls("X", ig::read); });
  CHECK(calls.code_count() == cycle_codes.size());
  document.put_code("Parsing.G83");
  CHECK(cycle_codes.at(document.block().find(calls).value()) == "G83");
}
