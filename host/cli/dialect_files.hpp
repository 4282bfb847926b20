/// Which files a dialect or a machine was read from.
#pragma once

#include <string>
#include <vector>

#include "isogloss/engine/dialect.hpp"

namespace isogloss::cli {

/// Its own file, and those in which something of it stands. Some may stand more than once, or be empty.
std::vector<std::string> files_of_parts(const Dialect& dialect);

/// Its own, those that it extends and includes, those of its tables, and all of a machine's folder. Some may stand more
/// than once, or be empty.
std::vector<std::string> files_of_dialect(const Dialect& dialect);

}  // namespace isogloss::cli
