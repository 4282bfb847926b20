/// Watches over a process that works for strangers: hands on what it prints, and ends it where it goes too far.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace isogloss::cli::sandbox {

/// How the process ended.
struct End {
  enum class How : std::uint8_t { by_itself, not_begun, refused, over_limit, by_signal };
  How how = How::by_itself;
  int number = 0;                         ///< exit status, or signal
  std::string why;                        ///< the call that was refused, the limit, or what kept it from beginning
  int signal = 0;                         ///< that the supervisor was sent meanwhile
  std::string lost;                       ///< why standard output took no more; empty where it did
  bool has_said = false;                  ///< something was printed where diagnostics go
  std::vector<std::string> lost_outputs;  ///< of the outputs that are handed on: as `lost`
};

struct Limits {
  std::uint64_t seconds = 0, memory_mib = 0, printed_bytes = 0;  ///< 0: none
  std::vector<std::string> readable;                             ///< as in its Confinement
};

/// The supervisor's ends of what connects both.
struct Connections {
  int socket = -1;            ///< from where the listener for refused calls comes
  int out = -1, errors = -1;  ///< its standard output and standard error; one for both where they are one file
  /// An output that is no file of a disk: the process writes to a pipe, since a terminal would obey it.
  struct Output {
    int pipe = -1, target = -1;
  };
  std::vector<Output> outputs{};
};

End watch_over(pid_t process, Connections connections, const Limits& limits);

}  // namespace isogloss::cli::sandbox
