/// Whether two texts make the same motions, for changes that must not change one.
#pragma once

#include "lsp/open_program.hpp"

namespace isogloss::editors {

/// Runs both. Empty where motions, events and the diagnostics of each line are the same; else what differs: "the
/// motions would not be the same".
std::string why_not_same(const Setup& setup, const std::string& path, const std::string& before,
                         const std::string& after, const Surroundings& around);

}  // namespace isogloss::editors
