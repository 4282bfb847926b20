/// The change of a dialect's file that puts its chain into a valid order.
#pragma once

#include <string>
#include <vector>

#include "isogloss/engine/dialect.hpp"

namespace isogloss::cli {

/// A unified diff of the dialect's own file, which `patch -p0` and `git apply -p0` apply. `wanted`: the aliases in a
/// valid order. Empty, with a reason, when no change of this file alone gives that order.
std::string order_patch(const Dialect& dialect, const std::vector<std::string>& wanted, std::string& reason);

/// Two texts as a unified diff with three lines around each change. Empty when they are the same.
std::string unified_diff(const std::string& path, const std::string& before, const std::string& after);

}  // namespace isogloss::cli
