#include "process_use.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace isogloss::cli {

namespace fs = std::filesystem;

ProcessUse use_of(pid_t process) {
  ProcessUse out;
  std::error_code error;
  for (fs::directory_iterator thread("/proc/" + std::to_string(process) + "/task", error), end; !error && thread != end;
       thread.increment(error)) {
    ++out.threads;
    if (out.resident_mib != 0) continue;
    // A thread that has ended, as the first one may have, has no memory any more. The others have the same.
    std::uint64_t size = 0, resident = 0;
    std::ifstream(thread->path() / "statm") >> size >> resident;
    out.resident_mib = resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) >> 20;
  }
  return out;
}

}  // namespace isogloss::cli
