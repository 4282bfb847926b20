/// The options of a run, which `run`, `explain` and others share.
#pragma once

#include <array>

#include "run_request.hpp"
#include "session.hpp"

namespace isogloss::cli {

struct ProgramOptions : RunRequest {
  unsigned watchdog = 10;

  void add_to(CommandLine& line);
  /// The files and folders that these options name, for are_apart(); names of dialects and machines stand among them.
  std::vector<std::string> files() const;
  /// What the options of one side (-a, --machine-a) put in the place of -d and -m. A whole machine names its dialect,
  /// so that a machine and a dialect of the two levels do not go together; tables lie over any dialect. False, with a
  /// diagnostic, where the machine is not found.
  bool take_side(const std::string& own_dialect, const std::string& own_machine, Workspace& workspace);
  /// False, and reported, where the options of both sides leave no use for -d, or none for -m.
  bool serves_a_side(const std::array<std::string, 2>& own_dialects, const std::array<std::string, 2>& own_machines,
                     Workspace& workspace) const;
};

}  // namespace isogloss::cli
