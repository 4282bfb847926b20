/// The tables that a user brings beside a dialect.
#pragma once

#include <vector>

#include "isogloss/engine/dialect.hpp"
#include "isogloss/engine/library.hpp"

namespace isogloss {

/// Adds the dependencies that the dialect lacks, each with the plugin that has it; a Chain puts the rows of the others
/// over those of the dialect. False, and reported, when no plugin has one.
bool add_missing(const std::vector<DependencyElement>& own, Dialect& dialect, Library& library, DiagnosticSink& sink);

/// Lists the plugin that has this dependency with the dialect's. False, and reported, when no plugin has it.
bool add_plugin_of(const DependencyElement& element, Dialect& dialect, Library& library, DiagnosticSink& sink);

}  // namespace isogloss
