/// Programs of a batch in processes of their own, several at once: what one of them does to itself, no other feels.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace isogloss::cli::batch {

struct ChildLimits {
  std::uint64_t seconds = 0;     ///< of the clock; 0: none
  std::uint64_t memory_mib = 0;  ///< resident; 0: none
};

/// How a process ended, and what it had written.
struct ChildEnd {
  enum class How : std::uint8_t { exited, killed_by_signal, out_of_time, out_of_memory, not_started };
  How how = How::exited;
  int number = 0;           ///< exit status, signal, or the error that kept it from starting
  std::string out, errors;  ///< standard output whole; of standard error the first 64 KiB
};

class Children {
 public:
  /// The arguments of the next process, which is this command once more; empty: there is none for now.
  using Next = std::function<std::vector<std::string>(std::size_t& work)>;
  /// Of the work with this number; in the order in which processes end. There may be a next one again after it.
  using Ended = std::function<void(std::size_t work, ChildEnd end)>;

  /// Up to `most` at once, and fewer where the system gives no more, until all have ended and there is no next one.
  /// False: a signal to end came; the processes at work are killed.
  static bool run(unsigned most, const ChildLimits& limits, const Next& next, const Ended& ended);
};

/// In such a process: it ends with the one that started it, the process `parent`.
void end_with_parent(std::uint64_t parent);

}  // namespace isogloss::cli::batch
