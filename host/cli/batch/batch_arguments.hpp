/// What `isogloss batch` was asked for.
#pragma once

#include "batch/children.hpp"
#include "batch/program_list.hpp"
#include "program_options.hpp"
#include "run/run_budgets.hpp"
#include "sandbox/untrusted.hpp"

namespace isogloss::cli::batch {

/// A part of the programs: 2 of 8.
struct Shard {
  std::uint64_t number = 1, count = 1;
};

struct BatchArguments {
  CommonOptions common;
  ProgramOptions program;
  RunBudgets budgets;
  UntrustedOptions untrusted;
  ProgramPlaces places;
  std::string output, shard_text;
  std::vector<std::string> changed_since;
  std::uint32_t jobs = 0, slurm_parts = 0;
  std::string slurm_options;
  bool holds_back = false;  ///< --no-submit
  std::uint64_t maximum_seconds = 600;
  bool merges = false, retries = false;
  /// Hidden, for the process of one program.
  std::string work;
  std::uint64_t parent = 0;

  std::vector<std::string> given;  ///< all of the above as it was written, for those processes
  Shard shard;
};

}  // namespace isogloss::cli::batch
