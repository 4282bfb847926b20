/// Both runs, each on a thread of its own, in step with the comparison.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <thread>

#include "diff/evidence.hpp"
#include "diff/line_order.hpp"
#include "diff/program_text.hpp"

namespace isogloss::cli::parting {

/// One side: a program in a dialect.
struct RunOfSide {
  SideOf side;
  const ProgramText* program = nullptr;
  RunOptions options;
};

/// Starts both runs and lets `work` take what they send; `run` is called on the thread of each side, `stop` when `work`
/// has ended, so that runs that still go on end, too.
class TwoThreads {
 public:
  TwoThreads(const std::function<void(std::size_t side)>& run, std::function<void()> stop);
  ~TwoThreads();
  TwoThreads(const TwoThreads&) = delete;
  TwoThreads& operator=(const TwoThreads&) = delete;

 private:
  std::function<void()> stop_;
  std::array<std::thread, 2> threads_;
};

}  // namespace isogloss::cli::parting
