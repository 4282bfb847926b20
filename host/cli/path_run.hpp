/// One program through one dialect, for a picture: its path, and what was reported.
#pragma once

#include "kept_program.hpp"
#include "program_options.hpp"
#include "run/run_budgets.hpp"
#include "tool_path.hpp"

namespace isogloss::cli {

/// Hands on what is reported, and keeps the first of it.
class KeptReports : public DiagnosticSink {
 public:
  explicit KeptReports(DiagnosticSink& sink) : sink_(sink) {}
  void add(Diagnostic diagnostic) override;
  std::vector<Diagnostic> kept;
  std::uint64_t number = 0;

 private:
  static constexpr std::size_t most_ = 2'000;
  DiagnosticSink& sink_;
};

struct PathRun {
  explicit PathRun(DiagnosticSink& sink) : reports(sink) {}
  std::unique_ptr<LinkedDialect> linked;
  RunOptions options;
  ToolPath path;
  KeptReports reports;
  std::uint64_t blocks = 0;
};

/// Null, and reported, when the run cannot start.
std::unique_ptr<PathRun> run_path(const KeptProgram& program, ProgramOptions options, const ToolPathOptions& path,
                                  const RunBudgets& budgets, Session& session);

}  // namespace isogloss::cli
