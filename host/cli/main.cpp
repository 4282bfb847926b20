#include <fcntl.h>
#include <unistd.h>

#include "command.hpp"
#include "crash_guard.hpp"
#include "prepared_heap.hpp"
#include "sandbox/untrusted.hpp"

namespace {

/// A stream that was closed would be the number of the next file, and diagnostics would stand in the output. What takes
/// its place fails as the closed one does.
void take_places_of_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace

int main(int argc, char** argv) {
  take_places_of_closed_streams();
  isogloss::cli::prepare_heap();
  isogloss::cli::guard_crashes(argv);
  isogloss::cli::watch_calls(10);  // `run` takes the time that its option gives
  const int status = isogloss::cli::run_main({argv + 1, argv + argc});
  isogloss::cli::end_untrusted(status);
  isogloss::cli::expect_end();
  return status;
}
