/// The row of a cutting edge in the table of tool offsets.
#pragma once

#include <cstdint>

#include <isogloss/cnc/tool_dimension.hpp>
#include <isogloss/cnc/tool_names.hpp>

namespace siemens {

using namespace ig::cnc;

/// Row 5 for D1 of tool 5. Row 5.2 for D2 where the table has one, else the row that lies `step` rows behind.
inline std::int64_t edge_row(const ig::Service<ig_tool_offset_1>& table, std::int64_t tool, std::int64_t edge,
                             std::int64_t step) {
  if (edge <= 1 || tool >= IG_TOOL_INDEX_STEP) return tool + (edge - 1) * step;
  const std::int64_t indexed = indexed_tool(tool, edge);
  return tool_dimension(table, indexed, ToolDimension::length) ? indexed : tool + (edge - 1) * step;
}

}  // namespace siemens
