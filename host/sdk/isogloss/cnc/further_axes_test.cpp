#include "isogloss/cnc/further_axes.hpp"

#include <catch2/catch.hpp>

#include <set>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

TEST_CASE("six axes follow X Y Z A B C") {
  CHECK_FALSE(is_further_axis(5));
  CHECK(is_further_axis(6));
  CHECK(is_further_axis(11));
  CHECK_FALSE(is_further_axis(12));
}

TEST_CASE("each further axis has a word, a mode, a name and a position of its own") {
  BlockDocument document;
  const auto words = document.create([] { return FurtherAxisWords(ig::write, ig::write); });
  const auto positions = document.create([] { return FurtherAxisPositions(ig::read | ig::write); });
  std::set<ig_field> fields;
  for (std::uint32_t axis = 6; axis < 12; ++axis)
    for (const ig_field field :
         {words.word(axis).id(), words.mode(axis).id(), positions.name(axis).id(), positions.position(axis).id()})
      fields.insert(field);
  CHECK(fields.size() == 24);
}
