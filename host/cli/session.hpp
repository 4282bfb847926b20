/// What every command needs: its workspace, and how diagnostics are written.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "isogloss/engine/diagnostic_writer.hpp"
#include "output_file.hpp"
#include "terminal.hpp"
#include "workspace.hpp"

namespace isogloss::cli {

struct CommonOptions {
  std::vector<std::string> plugins, dialects, machines;
  std::string diagnostics = "text", diagnostics_output;
  std::uint64_t repeats = 5;
  static constexpr std::uint64_t many_errors = 100'000;
  std::uint64_t maximum_errors = many_errors;
  bool warnings_are_errors = false, any_plugins = false;
  bool tells_missing_folders = true;  ///< not in a process whose parent has told of them
  bool loads_plugins = true;          ///< not in a process that no plugin may run in

  void add_to(CommandLine& line);
};

class Session : public Workspace {
 public:
  explicit Session(const CommonOptions& options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  DiagnosticWriter& diagnostics() { return diagnostics_; }
  Progress& progress() { return progress_; }
  /// From now on, whatever --diagnostics-output names; diagnostics already written to that file are dropped.
  void report_to_stderr() { diagnostics_file_.reset(); }
  /// From now on diagnostics are given to `taker` as text; a server has no use for standard error.
  void report_to(std::function<void(std::string_view)> taker) { taker_ = std::move(taker); }
  /// input_errors when there were errors, internal_fault when a plugin broke the contract, else success.
  int status() const;

 private:
  std::string diagnostics_output_;
  std::unique_ptr<OutputFile> diagnostics_file_;
  std::function<void(std::string_view)> taker_;
  Progress progress_;
  DiagnosticWriter diagnostics_;
};

/// True once diagnostics could not be written, to --diagnostics-output or standard error: exit status cannot_start.
bool diagnostics_were_lost();

/// Stays until the process ends, which frees all of it at once: to take thousands of small parts down one by one is
/// what short programs would wait for.
template <class T>
void keep_to_the_end(std::unique_ptr<T> whole) {
  static auto& kept = *std::make_unique<std::vector<std::unique_ptr<T>>>().release();
  kept.push_back(std::move(whole));
}

/// Where the command itself stands; what is installed with it is found from there.
std::filesystem::path folder_of_executable();

}  // namespace isogloss::cli
