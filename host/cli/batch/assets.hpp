/// The files of the overview, which the build embeds into the command: page/.
#pragma once

#include <string_view>

namespace isogloss::cli::batch {

/// The text of a file by its name; "overview.css.hash" and "overview.js.hash" are what a security policy calls them.
/// Empty: there is none.
std::string_view asset(std::string_view name);

}  // namespace isogloss::cli::batch
