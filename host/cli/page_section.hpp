/// One section of a documentation page, by its heading.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isogloss::cli {

/// The headings of a page, in order. Lines that look like one inside a fence are none.
std::vector<std::string> headings(std::string_view page);

/// From the heading, in any case, to the next one of its level; empty when there is none.
std::optional<std::string> section_of(std::string_view page, std::string_view title);

}  // namespace isogloss::cli
