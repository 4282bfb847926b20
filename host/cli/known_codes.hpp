/// All diagnostics that the host and the plugins declare.
#pragma once

#include <string>
#include <vector>

#include "isogloss/engine/diagnostic.hpp"
#include "isogloss/engine/library.hpp"

namespace isogloss {

struct KnownCode {
  DiagnosticInfo info;
  std::string plugin;  ///< "host", or the names of all plugins that declare it, separated by ", "
};

/// The host's, then those of the plugins that are loaded. A code that several plugins declare with the same text, from
/// a header of the SDK, stands once.
std::vector<KnownCode> known_codes(const Library& library);

}  // namespace isogloss
