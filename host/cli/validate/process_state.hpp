/// What belongs to the whole process, or to its thread, and what no plugin may change: locale, signals, limits, timers,
/// the processor's arithmetic.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace isogloss::cli {

/// The settings when this was made.
class ProcessState {
 public:
  ProcessState();
  /// A sentence for each setting that is another one now.
  std::vector<std::string> changes() const;

 private:
  std::map<std::string, std::string> settings_;
};

}  // namespace isogloss::cli
