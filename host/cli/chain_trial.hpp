/// Whether a program can begin at all.
#pragma once

#include <stdexcept>
#include <string>

#include "isogloss/engine/chain.hpp"
#include "session.hpp"

namespace isogloss::cli {

/// Makes a chain, as a run does before its first block. False, and reported with all that was said of it: a table, an
/// option or a syntax does not take what it is given.
bool can_begin(const LinkedDialect& linked, const ChainSettings& settings, Session& session);

/// A run of `path` that kept its reports for itself has ended with `fault` before its first block. Reports why;
/// cannot_start.
int report_no_begin(const LinkedDialect& linked, const ChainSettings& settings, const std::string& path,
                    const std::runtime_error& fault, Session& session);

}  // namespace isogloss::cli
