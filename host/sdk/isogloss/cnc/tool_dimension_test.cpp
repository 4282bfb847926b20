#include "isogloss/cnc/tool_dimension.hpp"

#include <catch2/catch.hpp>
#include <map>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

struct AskedTools {
  std::map<std::pair<std::int64_t, std::uint32_t>, double> cells;
  ig_tool_offset_1 provided{sizeof(ig_tool_offset_1), 0, this, &get, nullptr};
  BlockDocument document;

  static std::int32_t get(void* self, std::int64_t row, std::uint32_t column, double* mm) {
    const auto& cells = static_cast<const AskedTools*>(self)->cells;
    const auto found = cells.find({row, column});
    *mm = found == cells.end() ? 99 : found->second;
    return found == cells.end() ? 0 : 1;
  }
  ig::Service<ig_tool_offset_1> service() {
    document.services["isogloss.tool-offset/1"] = &provided;
    return document.create([] { return ig::Service<ig_tool_offset_1>("isogloss.tool-offset/1"); });
  }
};

}  // namespace

TEST_CASE("geometry and wear add up, each for its dimension") {
  AskedTools t;
  t.cells = {{{3, 0}, 100}, {{3, 1}, -0.5}, {{3, 2}, 6}, {{3, 3}, 0.25}};
  CHECK(tool_dimension(t.service(), 3, ToolDimension::length) == 99.5);
  CHECK(tool_dimension(t.service(), 3, ToolDimension::radius) == 6.25);
}

TEST_CASE("a missing geometry or wear counts as 0") {
  AskedTools t;
  t.cells = {{{3, 0}, 100}, {{4, 1}, -0.5}};
  CHECK(tool_dimension(t.service(), 3, ToolDimension::length) == 100.0);
  CHECK(tool_dimension(t.service(), 4, ToolDimension::length) == -0.5);
}

TEST_CASE("a tool that the table does not have has no dimension, nor has any without a table") {
  AskedTools t;
  CHECK_FALSE(tool_dimension(t.service(), 3, ToolDimension::radius).has_value());
  BlockDocument document;
  const auto none =
      document.create([] { return ig::Service<ig_tool_offset_1>("isogloss.tool-offset/1", ig::Need::optional); });
  CHECK_FALSE(tool_dimension(none, 3, ToolDimension::radius).has_value());
}
