/// Tools that are called by name, and tools with several lengths: the numbers of both in a table of tool offsets.
#pragma once

#include <isogloss_tool.h>

#include <cstdint>
#include <optional>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// A member of a syntax: the names in the table of tools, through the service isogloss.tool-name/1.
class ToolNames {
 public:
  /// The offset number of the first tool of this name; nothing where no tool has it, no table has names, or the name is
  /// empty, which stands for any in the service.
  std::optional<std::int64_t> number(std::string_view name) const {
    const std::int64_t id = table_ && !name.empty() ? table_->find(table_->self, to_text(name), 0) : 0;
    return id != 0 ? std::optional(id) : std::nullopt;
  }
  /// The first tool behind the tool `id` of the table that has this name too: its sister, which the control takes when
  /// the life of the first has ended. Further lengths of one tool (5.1) are no sisters.
  std::optional<std::int64_t> sister(std::string_view name, std::int64_t id) const {
    if (!table_ || name.empty()) return std::nullopt;
    std::int64_t next = id;
    do next = table_->find(table_->self, to_text(name), next);
    while (next != 0 && next % IG_TOOL_INDEX_STEP == id % IG_TOOL_INDEX_STEP);
    return next != 0 ? std::optional(next) : std::nullopt;
  }
  /// Does the table give any tool a name? Then a name that it lacks is a mistake.
  bool has_names() const { return table_ && table_->find(table_->self, {nullptr, 0}, 0) != 0; }

 private:
  Service<ig_tool_name_1> table_{"isogloss.tool-name/1", Need::optional, "The names of tools."};
};

/// The offset number of a further length and radius of a tool: row "5.1" of tool 5. The index is 1 to 99.
constexpr std::int64_t indexed_tool(std::int64_t tool, std::int64_t index) {
  return tool + index * std::int64_t{IG_TOOL_INDEX_STEP};
}

}  // namespace ig::cnc
