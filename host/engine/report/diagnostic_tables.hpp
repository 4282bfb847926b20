/// The parts of the host's table of diagnostics.
#pragma once

#include <vector>

#include "isogloss/engine/diagnostic.hpp"

namespace isogloss {

/// Dialect files, machines and tables, restarts: 0100 to 0199.
std::vector<DiagnosticInfo> dialect_diagnostics();
/// Links, libraries and plugins: 0200 to 0399.
std::vector<DiagnosticInfo> link_diagnostics();
/// Runs, cases, the command, pictures, editors: from 0400.
std::vector<DiagnosticInfo> run_diagnostics();

}  // namespace isogloss
