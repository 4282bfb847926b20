/// Stops a run between two of its blocks: for debuggers, and for whoever feeds a program block by block.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/explain.hpp"

namespace isogloss {

/// The block that a run executes next. The texts are good until BlockListener::before() returns.
struct NextBlock {
  std::uint64_t number = 0;   ///< of the blocks that the run executes, in whatever file, from 1
  std::string_view file;      ///< as diagnostics name it; the same file has the same address through the whole run
  std::uint32_t line = 0;     ///< from 1
  std::uint32_t column = 0;   ///< of the block's first byte, from 0: a line may hold several blocks
  std::uint32_t lines = 1;    ///< that the block reaches over
  std::uint32_t depth = 0;    ///< of called programs; 0: the main program
  std::uint64_t call = 0;     ///< tells calls apart: each call of a program has a number of its own in the run
  std::uint32_t pass = 1;     ///< of a call that repeats its program
  std::string_view text;      ///< from the block to the end of its line, or of the lines that are joined with it
  std::uint64_t waiting = 0;  ///< executed blocks that exporters have not got yet, since a syntax looks ahead
};

/// A run that stands between two blocks. Valid until BlockListener::before() returns, on the thread that runs.
class StandingRun {
 public:
  /// The programs under way, the main program's first.
  virtual std::vector<ExplainedFrame> frames() const = 0;
  /// The chain with the state that the executed blocks left: its document is read only.
  virtual Chain& chain() = 0;
  /// Executes a block that stands in no program, such as "#101=5": it counts as no block, reaches no exporter, cannot
  /// call or jump, and is not post-logic's concern. Returns what it reported; with an error nothing was assigned.
  virtual std::vector<Diagnostic> execute(std::string_view block) = 0;

 protected:
  ~StandingRun() = default;
};

/// Is asked before each block of a run, comments and empty statements included (RunOptions::listener).
class BlockListener {
 public:
  virtual ~BlockListener() = default;
  /// Called on the thread that runs, which waits as long as the function takes. False ends the run before the block.
  /// With look-ahead, exporters have not got the last blocks yet (`waiting`): they get them before the run ends. What
  /// it throws comes out of run().
  virtual bool before(const NextBlock& next, StandingRun& run) = 0;
};

/// The text of a block that assigns a value to a variable, in the words of the control: the row "assign variable" of
/// its texts (isogloss.program-text/1), or else NAME=VALUE. `value` is a number or a text as a program writes it.
std::string assignment_text(Chain& chain, std::string_view name, std::string_view value);

/// A line of a file and what a run finds there.
struct BlockLine {
  std::uint32_t line = 0;   ///< on which the block begins, from 1
  std::uint32_t lines = 1;  ///< that it reaches over
};

/// The lines on which a statement begins, in order: neither blank lines nor those that hold nothing but a comment.
/// Scans the text and executes nothing; reports nothing. Throws std::runtime_error when a syntax cannot be created.
std::vector<BlockLine> find_block_lines(const LinkedDialect& linked, Source& source, const RunOptions& options);

}  // namespace isogloss
