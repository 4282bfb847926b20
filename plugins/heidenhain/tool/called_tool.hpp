/// The tool that a statement names: TOOL CALL 5, 5.1, Q1, "EM10", QS1.
#pragma once

#include <optional>
#include <string_view>

#include <isogloss/cnc/tool_dimension.hpp>
#include <isogloss/cnc/tool_names.hpp>

#include "language/klartext_values.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// Its number, and its row in the table of tools, which differs where it has a step index. No row: the fraction of the
/// number is no index.
struct CalledTool {
  double number = 0;
  std::optional<double> row = 0;
  bool is_given = false;  ///< a number, or a name that the table may lack
  bool is_known = false;
};

/// A member of the syntax that reads TOOL CALL and TOOL DEF.
class CalledTools {
 public:
  /// The tool at `i`, which moves behind it.
  CalledTool read(ig::Block& b, const Values& values, std::string_view text, std::size_t& i) const;

  /// The row of 5.1, or that of tool 5, with a diagnostic, where the table has no such row.
  double present_row(ig::Block& b, const CalledTool& tool, std::string_view text, std::size_t begin,
                     std::size_t end) const;

 private:
  CalledTool quoted(ig::Block& b, const Values& values, std::string_view text, std::size_t& i) const;
  CalledTool named(ig::Block& b, const Values& values, std::string_view name, ig::Where where) const;
  void report_sisters(ig::Block& b, const Values& values, std::int64_t first, ig::Where where,
                      std::string_view name) const;

  ToolNames names_;
  ig::Service<ig_tool_offset_1> table_{"isogloss.tool-offset/1", ig::Need::optional, "The rows of step indices."};
};

}  // namespace heidenhain
