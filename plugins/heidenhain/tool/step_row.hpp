/// The number of a tool with a step index, as TOOL CALL and FN 18 give it.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include <isogloss/cnc/tool_names.hpp>

namespace heidenhain {

using namespace ig::cnc;

/// The row 5.1 in the table of tools; nothing for a number whose fraction is no step index, 1 to 9.
inline std::optional<std::int64_t> step_row(double number) {
  const double tool = std::floor(number), tenths = (number - tool) * 10, index = std::round(tenths);
  const bool is_index = index >= 1 && index <= 9 && std::fabs(tenths - index) < 1e-6;
  if (!is_index || !(tool >= 0 && tool < IG_TOOL_INDEX_STEP)) return std::nullopt;
  return indexed_tool(static_cast<std::int64_t>(tool), static_cast<std::int64_t>(index));
}

}  // namespace heidenhain
