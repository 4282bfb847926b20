/// What a process gives up before it works for strangers.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "sandbox/reading.hpp"

namespace isogloss::cli::sandbox {

struct Confinement {
  std::vector<std::string> readable;  ///< files, and folders with all that is below them
  std::uint64_t processor_seconds = 0;
  std::uint64_t address_space_bytes = 0, file_bytes = 0;  ///< 0: no limit
};

/// Gives up the calls that write, connect, start or signal others, and what goes beyond the limits. The first call that
/// is refused waits until whoever holds the other end of `socket` decides. An empty text, or why nothing may run now.
std::string confine(const Confinement& confinement, int socket);

/// Why this system cannot do it; empty where it can.
std::string fault_of_system();
/// The call that a confined process waits in, when it is refused: "openat (/etc/passwd)". Empty when the process has
/// ended meanwhile, and when the call was one of reading that it may go on with.
std::string refused_call(int listener, pid_t process, const ReadablePlaces& places);

}  // namespace isogloss::cli::sandbox
