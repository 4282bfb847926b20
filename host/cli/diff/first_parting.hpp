/// Where the two sides part first inside of one block: both explain it, and their steps are compared.
#pragma once

#include <optional>
#include <string>

#include "diff/groups.hpp"
#include "diff/runs.hpp"

namespace isogloss::cli::parting {

/// The first syntax, in the order of its chain, that does something which the other side does not do alike.
struct FirstParting {
  std::string syntax_a, syntax_b;  ///< the same on both sides, or one of them; empty: that side has no such syntax
  std::string path, a, b;          ///< what it gave another value, and which; of a code: whether it is used
};

/// In the first pass over the lines of the block. Nothing where a side does not come there, or where both do the same.
std::optional<FirstParting> find_first_parting(const RunOfSide& a, const RunOfSide& b, const PartedBlock& block,
                                               Session& session);

}  // namespace isogloss::cli::parting
