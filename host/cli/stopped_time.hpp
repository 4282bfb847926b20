/// Time that counts for no limit of a process.
#pragma once

#include <algorithm>
#include <chrono>

namespace isogloss::cli {

/// How much longer than `wanted` a wait has taken that began at `begin`, where that is more than a busy machine
/// explains: then this process was stopped meanwhile, and those that it watches with it (SIGSTOP, a job that Slurm
/// suspends).
inline std::chrono::steady_clock::duration time_stopped(std::chrono::steady_clock::time_point begin,
                                                        std::chrono::steady_clock::duration wanted) {
  constexpr auto of_busy_machine = std::chrono::seconds(1);
  const auto beyond = std::chrono::steady_clock::now() - begin - wanted;
  return beyond > of_busy_machine ? beyond : std::chrono::steady_clock::duration(0);
}

}  // namespace isogloss::cli
