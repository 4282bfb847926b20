/// A path as the bytes that the page reads, and bytes as base64.
#pragma once

#include <string>
#include <string_view>

#include "catalogue.hpp"
#include "tool_path.hpp"

namespace isogloss::cli::viewing {

void append_base64(std::string& out, std::string_view bytes);

/// One column after the other, little-endian: points, turns, and of the moves lines, seconds, feeds, segments, contexts
/// and flags. Points are told from `origin`; `files` has the place of each file of the path in the page. `facts` gets
/// what the columns mean.
std::string payload(const ToolPath& path, const Point& origin, const std::vector<std::size_t>& files, Json& facts);

}  // namespace isogloss::cli::viewing
