#include "command.hpp"
#include "crash_guard.hpp"

int main(int argc, char** argv) {
  isogloss::cli::guard_crashes(argv);
  return isogloss::cli::run_main({argv + 1, argv + argc});
}
