#include "isogloss/cnc/leftovers.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

TEST_CASE("leftovers are the words that nobody took and the codes that nobody answered, with names of their own") {
  BlockDocument document;
  ig::Block block = document.block();
  document.put_code("Parsing.G81");
  document.put_word("Parsing.G81.Q", 2);
  const auto code = leftover(block, 0), word = leftover(block, 1);
  REQUIRE(code.has_value());
  REQUIRE(word.has_value());
  CHECK(code->kind == IG_LEFT_CODE);
  CHECK(code->name == "G81");
  CHECK(code->field == document.id("Parsing.G81"));
  CHECK(word->kind == IG_LEFT_WORD);
  CHECK(word->name == "G81.Q");
  CHECK_FALSE(leftover(block, 2).has_value());
}

TEST_CASE("a code is unanswered until a syntax takes it; a code that the block does not hold never is") {
  BlockDocument document;
  ig::Block block = document.block();
  const ig_field g08 = document.id("Parsing.G08");
  CHECK_FALSE(is_unanswered(block, g08));
  document.put_code("Parsing.G05");
  document.put_code("Parsing.G08");
  CHECK(is_unanswered(block, g08));
  block.take_code(&g08, 1);
  CHECK(block.has(g08));  // the code stays in the block for other syntaxes
  CHECK_FALSE(is_unanswered(block, g08));
  CHECK(is_unanswered(block, document.id("Parsing.G05")));
}

TEST_CASE("a word that nobody took is no unanswered code") {
  BlockDocument document;
  document.put_word("Parsing.X", 1);
  CHECK_FALSE(is_unanswered(document.block(), document.id("Parsing.X")));
}
