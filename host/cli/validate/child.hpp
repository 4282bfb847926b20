/// A check in a process of its own, so that no plugin can take the others, or the command, along.
#pragma once

#include <sys/types.h>

#include <optional>

#include "validate/check.hpp"

namespace isogloss::cli {

struct Outcome {
  const Check* check = nullptr;
  std::string skipped{};  ///< why it did not run, or not to its end; empty: it ran
  std::vector<Finding> findings{};
  std::size_t more = 0;  ///< findings beyond most_findings
  std::vector<std::string> remarks{};
  double seconds = 0;

  static constexpr std::size_t most_findings = 20;
  bool held() const { return findings.empty() && skipped.empty(); }
};

/// Is told what the plugin is asked to do, again and again while a child is at work.
using Watcher = std::function<void(std::string_view at_work)>;

/// Ends the child when it takes longer or needs more memory than the options allow.
Outcome run_in_child(const Check& check, const ValidateOptions& options, const std::string& file,
                     const Watcher& watcher);
/// In this process: a crash ends the command, where a debugger sees it.
Outcome run_here(const Check& check, const ValidateOptions& options, const std::string& file);

/// Until all is written, or nobody reads.
void write_all(int descriptor, std::string_view text);
/// Has the process ended? It can still be waited for.
bool child_has_ended(pid_t child);

/// Does `work` survive in a process of its own? Without such a process it is run here.
bool survives(const Examination& e, const std::function<void()>& work);

}  // namespace isogloss::cli
