/// Checks of one plugin, several at once.
#pragma once

#include <span>
#include <vector>

#include "validate/child.hpp"

namespace isogloss::cli {

/// Is told what happens to the checks at work.
struct SideBySideListener {
  std::function<void(const Check&, std::string_view at_work)> at_work;
  std::function<void()> ended;  ///< one of them
};

/// The outcomes in the order of the checks. Up to `most` at once, each with a process that watches over its child; one
/// that measures times is alone.
std::vector<Outcome> run_side_by_side(std::span<const Check* const> checks, unsigned most,
                                      const ValidateOptions& options, const std::string& file,
                                      const SideBySideListener& listener);

}  // namespace isogloss::cli
