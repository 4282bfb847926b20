/// One program of a batch, in a process of its own.
#pragma once

#include "batch/batch_arguments.hpp"
#include "catalogue.hpp"

namespace isogloss::cli::batch {

/// Runs `arguments.work` and writes what the parent reads with read_work(). The exit status is that of `isogloss run`.
int do_work(const BatchArguments& arguments);

/// What such a process has written; null where it did not come to that.
struct Work {
  Json summary;                     ///< as `run --summary --json` writes it; null: the program was not run
  Json first;                       ///< the first error, or else the first warning; null: none
  std::vector<std::string> called;  ///< files of called programs
  std::vector<std::string> places;  ///< folders and files where programs were looked for
  bool looks_inside = false;        ///< and inside files of other names
};
std::optional<Work> read_work(const std::string& written);

}  // namespace isogloss::cli::batch
