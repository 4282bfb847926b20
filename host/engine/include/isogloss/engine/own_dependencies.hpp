/// The tables that a user brings beside a dialect.
#pragma once

#include <vector>

#include "isogloss/engine/dialect.hpp"
#include "isogloss/engine/library.hpp"

namespace isogloss {

/// Adds to the dialect those that it does not have, each with the plugin that has it; a Chain puts the rows of the
/// others over those of the dialect. False, and said, when no plugin has one.
bool add_missing(const std::vector<DependencyElement>& own, Dialect& dialect, Library& library, DiagnosticSink& sink);

}  // namespace isogloss
