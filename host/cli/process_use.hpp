/// What a process uses, as the kernel tells it. Nothing that the process calls itself changes it.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace isogloss::cli {

struct ProcessUse {
  std::uint64_t resident_mib = 0;
  unsigned threads = 0;
};

/// Of all its threads, also where the first one has ended. Nothing when the process is gone.
ProcessUse use_of(pid_t process);

}  // namespace isogloss::cli
