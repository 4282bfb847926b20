/// The host's side of the contract: one table of functions for each mode, the same plugin under all of them.
#pragma once

#include "isogloss.h"
#include "isogloss/engine/chain.hpp"

namespace isogloss {

/// Limits of one run that the tables enforce.
inline constexpr std::uint32_t maximum_items = 100'000;
inline constexpr std::size_t maximum_symbols = 1'000'000;

}  // namespace isogloss

/// What create() works with: one element of the dialect, and the chain that it becomes part of.
struct ig_link {
  isogloss::Chain* chain = nullptr;
  const std::vector<isogloss::OptionValue>* options = nullptr;
  const isogloss::LinkedSyntax* syntax = nullptr;  // null for a dependency
  isogloss::DependencyTable* table = nullptr;      // null for a syntax
  std::string failure;
  /// Why create() failed, also where the plugin does not say it.
  std::string reason() const { return failure.empty() ? "its create() gives no reason" : failure; }
  bool is_idle = false;
};
