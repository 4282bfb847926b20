/// Rows of tables of parameters that nothing acts on.
#pragma once

#include <vector>

#include "isogloss/engine/chain.hpp"

namespace isogloss::cli {

/// A note for each table that says what its rows mean (isogloss.row-meaning/1), and holds some without a meaning.
std::vector<Diagnostic> idle_rows(const LinkedDialect& linked, const Chain& chain);

}  // namespace isogloss::cli
