#include "isogloss/cnc/modal_group.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"
#include "isogloss/cnc/leftovers.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

struct DistanceGroup {
  BlockDocument document;
  ig::Codes group = document.create([] { return ig::Codes{"G90", "G91"}; });
  ig::Block block = document.block();
};

}  // namespace

TEST_CASE("a block without a code of the group selects none") {
  DistanceGroup g;
  CHECK(take_modal(g.block, g.group) == std::nullopt);
  CHECK(g.document.reports.empty());
}

TEST_CASE("one code of a group is taken without a report") {
  DistanceGroup g;
  g.document.put_code("Parsing.Flags.G91");
  CHECK(take_modal(g.block, g.group) == 1u);
  CHECK(g.document.reports.empty());
  CHECK_FALSE(leftover(g.block, 0).has_value());
}

TEST_CASE("of several codes of a group the last one in the block is in force, and ISO-0201 warns at it") {
  DistanceGroup g;
  g.document.put_code("Parsing.Flags.G91");
  g.document.put_code("Parsing.Flags.G90");
  CHECK(take_modal(g.block, g.group) == 0u);
  REQUIRE(g.document.reports.size() == 1);
  CHECK(g.document.reports[0] == BlockDocument::Report{"ISO-0201", IG_WARNING, "Parsing.Flags.G90", {"G90"}});
  CHECK_FALSE(leftover(g.block, 0).has_value());
}
