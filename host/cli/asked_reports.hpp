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
  /// Lets the run end when it has reported this many errors; 0: never.
  void end_at_errors(RunOptions& options, std::uint64_t most);
  bool has_ended_run() const { return most_errors_ != 0 && errors_ >= most_errors_; }

  std::vector<Diagnostic> all;
  /// Errors at the last place that had any, wanted or not: what ended the run is among them.
  std::vector<Diagnostic> last_errors;

 private:
  bool is_new(const Diagnostic& diagnostic);

  Wanted is_wanted_;
  std::unordered_set<std::size_t> seen_;
  std::uint64_t errors_ = 0, most_errors_ = 0;
};

/// Hears nothing: of a run that was heard before.
class Unheard : public DiagnosticSink {
 public:
  void add(Diagnostic) override {}
};

inline bool is_error(const Diagnostic& diagnostic) { return diagnostic.severity == Severity::error; }

}  // namespace isogloss::cli
