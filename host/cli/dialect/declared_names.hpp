/// Names in the declarations of syntaxes that nothing answers to: most often a slip of the pen of their author.
#pragma once

#include <vector>

#include "session.hpp"

namespace isogloss::cli {

/// A neighbour of after() or before() that no installed plugin has, a field that is read and that no installed plugin
/// writes, and an option whose name has a capital letter. All plugins are loaded where a name is not found at once.
std::vector<Diagnostic> unanswered_names(const LinkedDialect& linked, Library& library);

}  // namespace isogloss::cli
