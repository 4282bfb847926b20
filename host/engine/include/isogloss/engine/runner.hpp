/// Runs a program through a chain: cursor, budgets, look-ahead window, exporters.
#pragma once

#include <atomic>
#include <iosfwd>
#include <set>
#include <string>
#include <vector>

#include "isogloss/engine/chain.hpp"
#include "isogloss/engine/exporter.hpp"

namespace isogloss {

/// A call, a return or a jump that a block has requested, as the run performs it. Texts are alive until the call
/// returns.
struct FlowStep {
  enum class Kind : std::uint8_t { call, leave, again, jump };
  Kind kind = Kind::jump;
  std::string_view file;     ///< of the requesting block
  std::uint32_t line = 0;    ///< from 1
  std::uint32_t column = 0;  ///< of the block, from 1
  std::string_view label;    ///< as the request names it; empty: it names none
  std::string_view to_file;
  std::uint32_t to_line = 0;
};

class BlockListener;

struct RunOptions {
  ChainSettings chain;
  bool stop_on_error = false;                        ///< --on-error stop: the control's own stops end the run
  std::string program;                               ///< O1234: start at that program of the file
  std::uint64_t maximum_blocks = 0;                  ///< 0: no limit
  std::uint64_t maximum_motions = 1'000'000'000;     ///< blocks, and the steps of those that move by steps
  std::uint64_t maximum_jumps = 1'000'000;           ///< calls, returns and jumps
  std::uint64_t maximum_loop_blocks = 100'000'000;   ///< blocks that run again after jumps back
  std::uint64_t maximum_repeat_blocks = 10'000'000;  ///< blocks that run again because a call repeats its program
  std::uint32_t maximum_depth = 100;                 ///< of called programs
  /// Where called programs may be, in this order: folders, and files that hold several programs.
  std::vector<std::string> program_places;
  std::uint64_t stop_after_line = 0;  ///< ends the run after this line; 0: no limit (explain)
  std::string stop_in_file;           ///< the file of that line, by name; empty: the main program's
  std::uint64_t stop_after_pass = 1;  ///< how often that line is run
  std::size_t maximum_line_bytes = 1u << 20;
  /// A program of more lines is scanned on a thread of its own, ahead of the run, where there are two processors; 0:
  /// never. The result is the same.
  std::uint64_t scans_ahead_after = 0;
  std::function<void(Chain&)> prepare;  ///< called once the chain is created, before its start; empty: none
  /// Called when a program in a file is called for the first time, with its name and the file; empty: none.
  std::function<void(std::string_view program, const std::string& file)> called;
  /// Called when a program is looked for in these places, by the names of files or inside all of them; empty: none.
  std::function<void(const std::vector<std::string>& places, bool inside_files)> searched;
  std::function<void(const FlowStep&)> moved;  ///< called for each call, return and jump; empty: none
  std::function<void(std::uint64_t blocks, std::uint64_t bytes)> progress;  ///< now and then; empty: none
  /// Asked before each block (stepping.hpp), borrowed; null: none.
  BlockListener* listener = nullptr;
  std::function<bool()> goes_on;  ///< asked as often; false ends the run, and its author reports why; empty: always
};

struct RunResult {
  std::uint64_t blocks = 0;
  std::uint64_t lines = 0;
  std::uint64_t bytes = 0;
  bool output_closed = false;
  bool stopped_by_alarm = false;
  std::uint64_t jumps = 0;  ///< calls, returns and jumps
};

/// A program's bytes, read in windows.
class Source {
 public:
  virtual ~Source() = default;
  /// The next bytes, as many as the buffer takes or fewer; 0 at the end.
  virtual std::size_t read(char* buffer, std::size_t size) = 0;
  /// True where read_at() works; the run keeps what can be read only once.
  virtual bool has_places() const { return false; }
  virtual std::size_t read_at(std::uint64_t, char*, std::size_t) { return 0; }
  /// True when what was read can no longer be read again.
  virtual bool is_lost() const { return false; }
  /// Why the last read gave nothing although the end is not reached; empty: it was the end.
  virtual std::string failure() const { return {}; }
  /// The same bytes once more, for another thread; null: they cannot be read twice at a time.
  virtual std::unique_ptr<Source> again() const { return nullptr; }
};
std::unique_ptr<Source> open_file(const std::string& path, std::string& error);  ///< "-": standard input
std::unique_ptr<Source> memory_source(std::string_view text);

/// Runs `source` (named `name` in diagnostics and events) to its end. Exporters may be empty.
RunResult run(const LinkedDialect& linked, Source& source, const std::string& name, const RunOptions& options,
              const std::vector<Exporter*>& exporters, DiagnosticSink& sink);

/// The rapid rates of a machine before a run: a chain of its own answers, since tables belong to a run. None
/// where run() would throw.
RapidRates rapid_rates(const LinkedDialect& linked, const ChainSettings& settings);

}  // namespace isogloss
