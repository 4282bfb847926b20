/// The case that shows a crash: the same run again, stopped before the build that crashed.
#pragma once

#include "program_options.hpp"

namespace isogloss::cli {

/// Hidden options of `run`, given by the crash guard to the process that it starts.
struct ReproducerRequest {
  std::string file, program;
  std::uint64_t build = 0;  ///< number of the build() that crashed, or of the last one before a scanner crashed
  std::uint32_t line = 0;   ///< of the block

  void add_to(CommandLine& command_line);
  /// Runs up to that build and writes the case; internal_fault when it was not reached.
  int write(Session& session, const ProgramOptions& program_options, RunOptions options) const;
};

}  // namespace isogloss::cli
