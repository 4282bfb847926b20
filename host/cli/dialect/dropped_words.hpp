/// What the edits of a dialect take away from the one that it extends: codes and words that nothing uses any longer.
#pragma once

#include <vector>

#include "session.hpp"

namespace isogloss::cli {

/// A note for each Remove and Replace after which no syntax takes a code or word that one of the extended dialect
/// takes.
std::vector<Diagnostic> dropped_words(const LinkedDialect& linked, Session& session);

}  // namespace isogloss::cli
