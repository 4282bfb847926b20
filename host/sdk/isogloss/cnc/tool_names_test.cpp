#include "isogloss/cnc/tool_names.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

struct NamedTools {
  ig_tool_name_1 provided{sizeof(ig_tool_name_1), 0, this, &find, nullptr};
  BlockDocument document;

  /// Tool 7 with two lengths, and its sister 9.
  static std::int64_t find(void*, ig_text name, std::int64_t after) {
    if (name.size != 0 && ig::to_view(name) != "EM10") return 0;
    return after == 0 ? 7 : after == 7 ? indexed_tool(7, 1) : after == indexed_tool(7, 1) ? 9 : 0;
  }
  ToolNames names() {
    document.services["isogloss.tool-name/1"] = &provided;
    return document.create([] { return ToolNames(); });
  }
};

}  // namespace

TEST_CASE("a tool is found by its name, and a table with names is told from one without") {
  NamedTools tools;
  const ToolNames names = tools.names();
  CHECK(names.number("EM10") == 7);
  CHECK_FALSE(names.number("EM11").has_value());
  CHECK_FALSE(names.number("").has_value());
  CHECK(names.has_names());
  CHECK(names.sister("EM10", 7) == 9);
  CHECK_FALSE(names.sister("EM10", 9).has_value());
  CHECK_FALSE(names.sister("EM11", 7).has_value());
  CHECK_FALSE(names.sister("", 7).has_value());
  BlockDocument document;
  const auto none = document.create([] { return ToolNames(); });
  CHECK_FALSE(none.number("EM10").has_value());
  CHECK_FALSE(none.sister("EM10", 7).has_value());
  CHECK_FALSE(none.has_names());
}

TEST_CASE("an index of a tool has a number of its own") {
  CHECK(indexed_tool(5, 1) == 100005);
  CHECK(indexed_tool(99'999, 9) == 999'999);
}
