/// A documentation page of a plugin, and one section of it by its heading.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isogloss::cli {

/// A page as a plugin holds it, which nobody has checked yet; "" for null.
std::string printable_page(const char* page);

/// The headings of a page, in order. Lines that look like one inside a fence are none.
std::vector<std::string> headings(std::string_view page);

/// From the heading, in any case, to the next one of its level; empty when there is none.
std::optional<std::string> section_of(std::string_view page, std::string_view title);

}  // namespace isogloss::cli
