#include "command.hpp"
#include "crash_guard.hpp"

int main(int argc, char** argv) {
  isogloss::cli::guard_crashes(argv);
  isogloss::cli::watch_calls(10);  // `run` takes the time that its option gives
  const int status = isogloss::cli::run_main({argv + 1, argv + argc});
  isogloss::cli::expect_end();
  return status;
}
