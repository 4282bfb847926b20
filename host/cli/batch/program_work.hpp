/// One program of a batch, in a process of its own.
#pragma once

#include <map>

#include "batch/batch_arguments.hpp"
#include "catalogue.hpp"

namespace isogloss::cli::batch {

/// Runs `arguments.work` and writes what the parent reads with read_work(). The exit status is that of `isogloss run`.
int do_work(const BatchArguments& arguments);

/// What such a process has written; null where it did not come to that.
struct Work {
  Json summary;                               ///< as `run --summary --json` writes it; null: the program was not run
  Json first;                                 ///< the first error, or else the first warning; null: none
  std::map<std::string, std::string> called;  ///< files of called programs, and their states when they were called
  struct Searched {
    std::string state;
    bool inside = false;  ///< inside files of other names, too
  };
  std::map<std::string, Searched> places;  ///< folders and files where programs were looked for
};
/// Whatever has written it: a plugin may have printed in its place.
std::optional<Work> read_work(const std::string& written);

}  // namespace isogloss::cli::batch
