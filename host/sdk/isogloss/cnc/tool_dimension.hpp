/// The length and the radius of a tool in a table of tool offsets, read through its service isogloss.tool-offset/1. In
/// mm, as the table holds them: where it holds diameters, the caller halves them.
#pragma once

#include <cstdint>
#include <optional>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// The column of the geometry; its wear is in the next one.
enum class ToolDimension : std::uint32_t { length = 0, radius = 2 };

/// Geometry and wear together; a missing one counts as 0. Nothing where the table has neither, or is not there. The sum
/// may exceed every number.
inline std::optional<double> tool_dimension(const Service<ig_tool_offset_1>& table, std::int64_t row,
                                            ToolDimension which) {
  if (!table) return std::nullopt;
  const auto column = static_cast<std::uint32_t>(which);
  double geometry = 0, wear = 0;
  const bool has_geometry = table->get(table->self, row, column, &geometry) != 0;
  const bool has_wear = table->get(table->self, row, column + 1, &wear) != 0;
  if (!has_geometry && !has_wear) return std::nullopt;
  return (has_geometry ? geometry : 0) + (has_wear ? wear : 0);
}

}  // namespace ig::cnc
