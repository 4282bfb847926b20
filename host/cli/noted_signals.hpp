/// The signals that end a command, noted instead.
#pragma once

#include <array>
#include <csignal>

namespace isogloss::cli {

/// As long as it lives, SIGINT, SIGTERM, SIGHUP and SIGQUIT are noted; afterwards they do what they did before. What is
/// ignored stays ignored. One at a time.
class NotedSignals {
 public:
  NotedSignals();
  ~NotedSignals();
  NotedSignals(const NotedSignals&) = delete;
  NotedSignals& operator=(const NotedSignals&) = delete;

  /// The last one that came; 0: none.
  static int last();

 private:
  static constexpr std::array numbers_{SIGINT, SIGTERM, SIGHUP, SIGQUIT};
  std::array<struct sigaction, numbers_.size()> before_{};
};

}  // namespace isogloss::cli
