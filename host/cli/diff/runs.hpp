/// Both runs, each on a thread of its own, in step with the comparison.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "diff/evidence.hpp"
#include "diff/line_order.hpp"
#include "kept_program.hpp"

namespace isogloss::cli::parting {

/// One side: a program in a dialect.
struct RunOfSide {
  SideOf side;
  const KeptProgram* program = nullptr;
  RunOptions options;
  unsigned watchdog = 0;          ///< seconds that a block may take; 0: any time
  std::uint64_t most_errors = 0;  ///< the run ends when it has reported as many; 0: never
};

/// Counts errors and keeps the first reports: those that say why a run did not start.
class CountedReports : public DiagnosticSink {
 public:
  void add(Diagnostic diagnostic) override {
    constexpr std::size_t most = 20;
    if (diagnostic.severity == Severity::error && ++errors_ == 1) first_error_ = diagnostic;
    if (first_.size() < most) first_.push_back(std::move(diagnostic));
  }
  std::uint64_t errors() const { return errors_; }
  const std::optional<Diagnostic>& first_error() const { return first_error_; }
  std::vector<Diagnostic>& first() { return first_; }

 private:
  std::uint64_t errors_ = 0;
  std::optional<Diagnostic> first_error_;
  std::vector<Diagnostic> first_;
};

/// Ends a run that does nothing but report errors.
class EndAtErrors : public Exporter {
 public:
  EndAtErrors(const CountedReports& reports, std::uint64_t most) : reports_(reports), most_(most) {}
  void begin(Document&, const SymbolTable&) override {}
  bool block(Document&, const SymbolTable&) override { return most_ == 0 || reports_.errors() < most_; }
  bool end() override { return true; }
  bool has_ended() const { return most_ != 0 && reports_.errors() >= most_; }

 private:
  const CountedReports& reports_;
  const std::uint64_t most_;
};

/// Starts both runs and lets `work` take what they send; `run` is called on the thread of each side, `stop` when `work`
/// has ended, so that runs that still go on end, too.
class TwoThreads {
 public:
  TwoThreads(const std::function<void(std::size_t side)>& run, std::function<void()> stop);
  ~TwoThreads();
  TwoThreads(const TwoThreads&) = delete;
  TwoThreads& operator=(const TwoThreads&) = delete;
  /// The run of this side does not go on: a plugin that is at work there is reported, which ends the process.
  void report_stall(std::size_t side);

 private:
  std::function<void()> stop_;
  std::array<std::thread, 2> threads_;
};

}  // namespace isogloss::cli::parting
