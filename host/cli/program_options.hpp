/// The options of a run, which `run`, `explain` and others share.
#pragma once

#include "run_request.hpp"
#include "session.hpp"

namespace isogloss::cli {

struct ProgramOptions : RunRequest {
  unsigned watchdog = 10;

  void add_to(CommandLine& line);
  /// What the options of one side (-a, --machine-a) put in the place of -d and -m. A whole machine names its dialect,
  /// so that a machine and a dialect of the two levels do not go together; tables lie over any dialect. False, with a
  /// The files and folders that these options name, for are_apart(); names of dialects and machines stand among them.
  std::vector<std::string> files() const;
  /// diagnostic, where the machine is not found.
  bool take_side(const std::string& own_dialect, const std::string& own_machine, Workspace& workspace);
};

}  // namespace isogloss::cli
