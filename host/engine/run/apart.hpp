/// Keeps a thread away from the processor of another one.
#pragma once

#include <sched.h>

namespace isogloss {

/// The scheduler likes to wake a thread on the processor of the one that asks it. There it takes from that one what it
/// gives. To be made and used by the thread that moves.
class Apart {
 public:
  Apart() { can_move_ = sched_getaffinity(0, sizeof allowed_, &allowed_) == 0; }

  /// The thread leaves this processor where it runs on it and has another one. Negative: not known.
  void from(int processor) {
    if (!can_move_ || processor < 0 || processor >= CPU_SETSIZE || processor != sched_getcpu()) return;
    cpu_set_t others = allowed_;
    CPU_CLR(static_cast<unsigned>(processor), &others);
    can_move_ = CPU_COUNT(&others) != 0 && sched_setaffinity(0, sizeof others, &others) == 0;
  }

 private:
  cpu_set_t allowed_;
  bool can_move_ = false;
};

}  // namespace isogloss
