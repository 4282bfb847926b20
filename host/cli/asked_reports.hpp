/// What a run reports, for a command that shows a part of it.
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_set>
#include <vector>

#include "isogloss/engine/diagnostic.hpp"
#include "isogloss/engine/runner.hpp"

namespace isogloss::cli {

/// Keeps what is wanted, each diagnostic once: a loop without end repeats its own without end. Lives as long as a run
/// whose options it ends.
class AskedReports : public DiagnosticSink {
 public:
  using Wanted = std::function<bool(const Diagnostic&)>;
  explicit AskedReports(Wanted is_wanted) : is_wanted_(std::move(is_wanted)) {}
  AskedReports(const AskedReports&) = delete;
  AskedReports& operator=(const AskedReports&) = delete;

  void add(Diagnostic diagnostic) override;
  /// Lets a run with these options end when it has reported this many errors; 0: never.
  void end_at_errors(RunOptions& options, std::uint64_t most);
  /// A run has ended so, and what it has not come to is not known.
  bool has_ended_run() const { return has_ended_run_; }
  std::uint64_t errors() const { return errors_; }

  std::vector<Diagnostic> all;
  /// Errors that are not wanted, at the last place that had such: what ended the run may be among them.
  std::vector<Diagnostic> last_errors;

 private:
  bool is_new(const Diagnostic& diagnostic);

  Wanted is_wanted_;
  std::unordered_set<std::size_t> seen_;
  std::uint64_t errors_ = 0;
  bool has_ended_run_ = false;
};

/// Hears nothing: of a run that was heard before.
class Unheard : public DiagnosticSink {
 public:
  void add(Diagnostic) override {}
};

inline bool is_error(const Diagnostic& diagnostic) { return diagnostic.severity == Severity::error; }

}  // namespace isogloss::cli
