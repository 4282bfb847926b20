/// Runs a program through a chain: cursor, budgets, look-ahead window, exporters.
#pragma once

#include <atomic>
#include <iosfwd>
#include <set>

#include "isogloss/engine/chain.hpp"
#include "isogloss/engine/exporter.hpp"

namespace isogloss {

struct RunOptions {
  ChainSettings chain;
  bool stop_on_error = false;         ///< --on-error stop: the control's own stops end the run
  std::string program;                ///< O1234: start at that program of the file
  std::uint64_t maximum_blocks = 0;   ///< 0: no limit
  std::uint64_t stop_after_line = 0;  ///< 0: no limit (explain)
  std::size_t maximum_line_bytes = 1u << 20;
  std::function<void(Chain&)> prepare;  ///< called once the chain is created, before its start; empty: none
  std::function<void(std::uint64_t blocks, std::uint64_t bytes)> progress;  ///< now and then; empty: none
};

struct RunResult {
  std::uint64_t blocks = 0;
  std::uint64_t lines = 0;
  std::uint64_t bytes = 0;
  bool output_closed = false;
  bool stopped_by_alarm = false;
};

/// A program's bytes, read in windows.
class Source {
 public:
  virtual ~Source() = default;
  /// Fills the buffer as far as it can; 0 at the end.
  virtual std::size_t read(char* buffer, std::size_t size) = 0;
};
std::unique_ptr<Source> open_file(const std::string& path, std::string& error);  ///< "-": standard input
std::unique_ptr<Source> memory_source(std::string_view text);

/// Runs `source` (named `name` in diagnostics and events) to its end. Exporters may be empty.
RunResult run(const LinkedDialect& linked, Source& source, const std::string& name, const RunOptions& options,
              const std::vector<Exporter*>& exporters, DiagnosticSink& sink);

}  // namespace isogloss
