/// Time that counts for no limit of a process.
#pragma once

#include <algorithm>
#include <chrono>

namespace isogloss::cli {

/// Of a process that looks every `tick`: how much later than that it looks now, where that is more than a busy machine
/// explains. Then it was stopped meanwhile, and those that it watches with it (SIGSTOP, a job that Slurm suspends).
inline std::chrono::steady_clock::duration time_stopped(std::chrono::steady_clock::time_point last_look,
                                                        std::chrono::steady_clock::duration tick) {
  constexpr auto of_busy_machine = std::chrono::seconds(1);
  const auto beyond = std::chrono::steady_clock::now() - last_look - tick;
  return beyond > of_busy_machine ? beyond : std::chrono::steady_clock::duration(0);
}

}  // namespace isogloss::cli
