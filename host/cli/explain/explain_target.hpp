/// PROGRAM:LINE, PROGRAM:10-20 and PROGRAM, as a user names them; and why the run has no block there.
#pragma once

#include <optional>
#include <string>

#include "isogloss/engine/explain.hpp"
#include "workspace.hpp"

namespace isogloss::cli {

struct NamedLines {
  std::string program;
  std::uint32_t first = 0, last = 0;  ///< 0: no lines are named
};

/// Empty, and reported, where the text does not name lines as it should. Lines::needed: PROGRAM alone is not enough.
enum class Lines { needed, optional };
std::optional<NamedLines> read_lines(const std::string& text, Lines lines, Workspace& workspace);

/// A file of fewer lines than the range is reported: what is not there is not explained.
void report_short_file(const NamedLines& lines, const std::string& file, Workspace& workspace);

std::string why_no_block(const ExplainReach& reach, const ExplainTarget& target, const std::string& path);

}  // namespace isogloss::cli
