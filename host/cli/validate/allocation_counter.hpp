/// Counts what the code of plugins allocates, in the process of one check.
#pragma once

#include <cstdint>

namespace isogloss::cli {

/// From its creation on, malloc() and its kin of every library in this process are counted, operator new included. The
/// libraries keep the counting functions to the end of the process.
class AllocationCounter {
 public:
  /// `is_complete` is false where the system gives no way to look into its libraries.
  AllocationCounter();
  bool is_complete() const { return is_complete_; }

  /// Allocations of this thread since the last start(), without those during host functions.
  static void start();
  static std::uint64_t stop();
  /// Allocated and not freed by this thread since the last start(), the host's included.
  static std::int64_t bytes();

  /// While one of these lives, the host is at work.
  class InHost {
   public:
    InHost();
    ~InHost();
    InHost(const InHost&) = delete;
    InHost& operator=(const InHost&) = delete;
  };

 private:
  bool is_complete_ = false;
};

}  // namespace isogloss::cli
