/// The point tables of the machine, which SEL PATTERN selects. HeidenhainPoints provides them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "tables/named_tables.hpp"

namespace heidenhain {

inline constexpr const char* point_table_service = "heidenhain.point-table/1";

/// A point in mm; an axis without a value is nothing.
struct TablePoint {
  std::array<std::optional<double>, 3> position{};
  std::optional<double> clearance{};  ///< the height at which the tool comes to the point
  bool is_faded = false;              ///< FADE Y: the point is not run
  std::string name{};                 ///< of the row, as the user wrote it
};

using PointTables = NamedTables<TablePoint>;

}  // namespace heidenhain
