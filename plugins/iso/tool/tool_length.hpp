/// Tool lengths from the machine's table, by the number of an H word.
#pragma once

#include <cmath>
#include <optional>

#include <isogloss/cnc/tool_dimension.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

/// A member of each syntax that asks for tool lengths.
class ToolLengths {
 public:
  explicit ToolLengths(ig::Need need) : table_("isogloss.tool-offset/1", need, "Length geometry and wear.") {}

  /// The row that H names; nothing, with a diagnostic, where it names none.
  static std::optional<std::int64_t> row(ig::Block& b, double h, ig::Where where) {
    const auto id = whole_number(h);
    if (!id) b.report(ig::diag("ISO-0225"), where, h);
    return id;
  }

  /// Geometry and wear together, in mm. Row 0 is length 0. The length is also 0, with a diagnostic, for a row that the
  /// table does not have or whose sum no number can hold.
  double length(ig::Block& b, std::int64_t row, ig::Where where) const {
    if (row == 0) return 0;
    const auto length = tool_dimension(table_, row, ToolDimension::length);
    if (length && std::isfinite(*length)) return *length;
    b.report(ig::diag("ISO-0223"), where, static_cast<double>(row));
    return 0;
  }

 private:
  ig::Service<ig_tool_offset_1> table_;
};

}  // namespace iso
