/// What the process that works tells the one that watches over it.
#pragma once

#include <atomic>

namespace isogloss::cli::sandbox {

constexpr std::size_t most_outputs = 64;

/// Lies in memory that both processes have. Whoever reads it trusts no value in it further than a plugin's.
struct SharedState {
  static constexpr int not_ended = -1;
  std::atomic<int> status = not_ended;
  std::atomic<bool> is_complete[most_outputs] = {};  ///< of the outputs, in their order
};

}  // namespace isogloss::cli::sandbox
