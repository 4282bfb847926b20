/// Where the run goes on after a block, and why: calls, returns, jumps, and conditions that fail.
#pragma once

#include <string>

#include "explain/facts.hpp"

namespace isogloss::cli {

/// "jumps back to line 8 (N20 G91), because [#101 LT 5] holds: #101 is 3". Empty: the next block follows, and nothing
/// has asked whether it does.
std::string go_clause(const Facts& facts);
/// What the conditions say, from "because" on; empty: the block has examined none.
std::string condition_clause(const Facts& facts);

}  // namespace isogloss::cli
