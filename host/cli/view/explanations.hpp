/// What each line of a program does, in one sentence.
#pragma once

#include <map>
#include <string>

#include "path_run.hpp"

namespace isogloss::cli::viewing {

/// By line; of a line that runs several times, what its first pass does.
using Sentences = std::map<std::uint32_t, std::string>;

/// Runs the program once more, up to `last`, and explains its lines from `first` on; at most `most` blocks, and no
/// longer than some seconds. `file`: of a called program; empty: the main program.
Sentences explain_lines(const PathRun& run, const KeptProgram& program, const std::string& file, std::uint32_t first,
                        std::uint32_t last, std::size_t most, Session& session);

}  // namespace isogloss::cli::viewing
