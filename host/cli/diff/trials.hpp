/// Several options of a syntax may differ, and the rows that it asks: which of them is the cause, a second run tells in
/// which one of them is the same on both sides.
#pragma once

#include "diff/compare.hpp"

namespace isogloss::cli::parting {

/// Runs both sides again as far as the first example of a cause. Causes that come first in the report, and early in the
/// program, are tried; the others keep all that may be the cause.
void try_causes(Report& report, const RunOfSide& a, const RunOfSide& b, const LineOrder* order,
                const std::vector<std::string>& ignored, Session& session);

}  // namespace isogloss::cli::parting
