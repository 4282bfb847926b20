/// The options of a run, which `run`, `explain` and others share.
#pragma once

#include "run_request.hpp"
#include "session.hpp"

namespace isogloss::cli {

struct ProgramOptions : RunRequest {
  unsigned watchdog = 10;

  void add_to(CommandLine& line);
};

}  // namespace isogloss::cli
