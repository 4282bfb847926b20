/// What a page says of options, beside what their declarations say.
#pragma once

#include <isogloss.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isogloss::cli {

/// A sentence for each option that the page does not name, or names with another default, range or choice, and for each
/// row of its table of options that no declaration has. Cells that say more than a value are left to the reader.
std::vector<std::string> page_faults(std::string_view page, std::span<const ig_option_decl> options);

}  // namespace isogloss::cli
