/// A run as Python asks for it, and what it becomes.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "isogloss/engine/runner.hpp"
#include "python_syntax.hpp"
#include "run_request.hpp"
#include "workspace.hpp"

namespace isogloss::python {

/// Filled by the package, read by one run at a time.
struct Request : RunRequest {
  std::string path;                 ///< of the program; with `text` its name
  std::optional<std::string> text;  ///< the program itself
  std::string home;                 ///< the folder of the command
  NamedFolders folders;
  bool zero_moves = false, adds_up = true;
  std::uint64_t maximum_diagnostics = 1'000'000;
  std::vector<std::shared_ptr<SyntaxSpec>> syntaxes;
};

/// Keeps diagnostics up to a number.
class BoundedList : public DiagnosticSink {
 public:
  explicit BoundedList(std::uint64_t most) : most_(most) {}
  void add(Diagnostic diagnostic) override {
    if (all.size() < most_)
      all.push_back(std::move(diagnostic));
    else
      is_full_ = true;
  }
  bool is_full() const { return is_full_; }
  std::vector<Diagnostic> all;

 private:
  std::uint64_t most_;
  bool is_full_ = false;
};

/// A run that is ready to begin. Made and used without the interpreter's lock, on one thread.
class PreparedRun {
 public:
  /// Opens, guesses and links; when something is wrong, it is reported and ready() is false.
  PreparedRun(Request& request, DiagnosticSink& sink);

  bool ready() const { return linked_ != nullptr && source_ != nullptr; }
  const LinkedDialect& linked() const { return *linked_; }
  Source& source() { return *source_; }
  RunOptions& options() { return options_; }
  /// The exception of a syntax in Python; it ends the run.
  Failure& failure() { return failure_; }

 private:
  void prepare(Request& request, Workspace& workspace);
  std::string open(Request& request, Workspace& workspace);
  void link(Request& request, Workspace& workspace, const std::string& dialect);

  Failure failure_;
  std::unique_ptr<Workspace> own_workspace_;
  std::unique_ptr<PythonPlugin> plugin_;
  std::unique_ptr<Source> source_;
  std::unique_ptr<LinkedDialect> linked_;
  RunOptions options_;
};

/// Ends a run after the block in which a syntax in Python failed, or once `ends` is set.
class Ends : public Exporter {
 public:
  Ends(const Failure& failure, const std::atomic<bool>& ends) : failure_(failure), ends_(ends) {}
  void begin(Document&, const SymbolTable&) override {}
  bool block(Document&, const SymbolTable&) override { return !failure_.is_set() && !ends_; }
  bool end() override { return true; }

 private:
  const Failure& failure_;
  const std::atomic<bool>& ends_;
};

}  // namespace isogloss::python
