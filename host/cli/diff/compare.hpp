/// The comparison of blocks: both runs, aligned, with the causes of what differs.
#pragma once

#include "diff/comparison.hpp"
#include "diff/runs.hpp"

namespace isogloss::cli::parting {

struct BlockResult {
  Report report;
  std::array<std::string, 2> faults;  ///< why a run could not go on; empty: it did
  std::array<std::vector<Diagnostic>, 2> reported_by_fault;
  std::array<bool, 2> is_cut{};      ///< ended by its errors
  std::uint64_t errors_of_both = 0;  ///< reported alike
  std::vector<std::string> unknown_fields;
};

BlockResult compare_blocks(const RunOfSide& a, const RunOfSide& b, const LineOrder* order,
                           const std::vector<std::string>& ignored, const ComparisonOptions& options, Session& session);

}  // namespace isogloss::cli::parting
