/// The parts of a batch as a job array of Slurm, and a job behind it that merges their results.
#pragma once

#include "batch/batch_arguments.hpp"

namespace isogloss::cli::batch {

/// Writes parts.sh and merge.sh into the folder `slurm` of the results, and submits them unless --no-submit was given.
/// An exit status; what is wrong is reported.
int run_on_slurm(const BatchArguments& arguments, Session& session);

}  // namespace isogloss::cli::batch
