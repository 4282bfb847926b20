#include "command.hpp"
#include "crash_guard.hpp"
#include "sandbox/untrusted.hpp"

int main(int argc, char** argv) {
  isogloss::cli::guard_crashes(argv);
  isogloss::cli::watch_calls(10);  // `run` takes the time that its option gives
  const int status = isogloss::cli::run_main({argv + 1, argv + argc});
  isogloss::cli::end_untrusted(status);
  isogloss::cli::expect_end();
  return status;
}
