/// A program under a debugger: runs on a thread of its own, and stands at blocks, strokes of cycles and diagnostics.
///
/// Where a run stands is a Position: before a block (the next one), or within a block that has run, after so many of
/// its strokes. Blocks are counted in the order in which they are executed, so that a position means the same in each
/// run of the same program with the same edits. Going back is running again from the start, silently, up to a position.
///
/// Edits of variables belong to a block: they are made again whenever a run comes to this block. A new edit drops those
/// behind it, since the blocks behind it may be others from then on.
///
/// Look-ahead: blocks that wait for others (cutter radius compensation) have been executed, but what they do is not
/// settled. The debugger shows a block when it is finished; variables are shown as they were then, and an edit takes
/// effect at the block that is shown although the run has read further: the run is repeated up to there.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "dap/breakpoints.hpp"
#include "dap/program_variables.hpp"
#include "dap/statement_lines.hpp"
#include "isogloss/engine/stepping.hpp"

namespace isogloss::dap {

/// What runs: linked, with its text in memory, so that each run sees the same.
struct DebuggedProgram {
  std::shared_ptr<const LinkedDialect> linked;
  RunOptions options;
  std::string path, text;
  bool stops_on_entry = false, stops_at_end = false;
};

struct Position {
  std::uint64_t block = 0;                            ///< from 1
  bool is_within = false;                             ///< the block has run; false: it is the next
  std::uint32_t done = 0;                             ///< strokes of the block that are done
  auto operator<=>(const Position&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 misreads it
};

/// Why a run stands, in the words of the protocol: "breakpoint", "function breakpoint", "exception", "step", "pause",
/// "entry", "goto".
struct Stop {
  std::string reason, description, text;
  std::vector<int> breakpoints;
  bool is_silent = false;  ///< the run stands where it stood before: the client is not told
};

using Frames = std::vector<ExplainedFrame>;

/// A block on its way from the cursor to the exporters.
struct BlockEntry {
  std::uint64_t number = 0;
  std::string_view file;
  std::uint32_t line = 0, column = 0, lines = 1, depth = 0, pass = 1;
  std::uint64_t call = 0;
  std::shared_ptr<const Frames> frames;
  std::vector<VariableUse> uses{};  ///< held until the block is finished
};

/// Where a run stands; good while it does.
struct Standing {
  Position position;
  BlockEntry entry;                    ///< the next block, or the one that it stands within
  const Document* document = nullptr;  ///< after the last finished block
  const SymbolTable* symbols = nullptr;
  Chain* chain = nullptr;
  StandingRun* run = nullptr;   ///< null: the run has read ahead, or stands within a block
  std::vector<Stroke> strokes;  ///< of the last finished block
  std::optional<Stroke> start;  ///< where they begin: program and machine; empty where it is not known
  Stop stop;
  /// The stroke whose end is the position; null: the block's end.
  const Stroke* stroke() const {
    if (!position.is_within || position.done > strokes.size()) return nullptr;
    if (position.done == 0) return start ? &*start : nullptr;
    return &strokes[position.done - 1];
  }
};

class DebugEvents {
 public:
  virtual ~DebugEvents() = default;
  virtual void stopped(const Stop& stop) = 0;
  /// A diagnostic, or the message of a log point.
  virtual void told(const Diagnostic& diagnostic) = 0;
  /// The run cannot begin, or broke off.
  virtual void failed(const std::string& why) = 0;
  virtual void logged(const std::string& text, const BlockEntry& entry) = 0;
  virtual void ended(bool has_errors) = 0;
};

class Debuggee : BlockListener, Exporter, DiagnosticSink {
 public:
  /// Both outlive it. Events come from the thread of the run.
  Debuggee(DebuggedProgram program, DebugEvents& events);
  ~Debuggee() override;
  Debuggee(const Debuggee&) = delete;
  Debuggee& operator=(const Debuggee&) = delete;

  void start();
  void set_breakpoints(std::shared_ptr<const BreakpointTable> table);

  enum class Step : std::uint8_t { go_on, into, over, out, back, reverse };
  /// False when the run does not stand.
  bool step(Step step);
  void pause();
  /// Ends the run; returns when its thread has ended.
  void quit();

  /// Calls `look` while the run stands and cannot move; false: it runs.
  bool look(const std::function<void(const Standing&, const ProgramVariables&)>& look);
  /// Returns a sentence when the assignment failed. `value`: a number or text as a program writes it.
  std::optional<std::string> assign(const std::string& name, const std::string& value);

  const DebuggedProgram& program() const { return program_; }
  StatementLines& statements() { return statements_; }

 private:
  enum class Aim : std::uint8_t { walk, into, over, out, seek, back, reverse };
  struct Plan {
    Aim aim = Aim::walk;
    Position from{}, target{};
    std::uint32_t depth = 0;
    Stop arrival{};  ///< the reason for standing at the target
  };
  struct Edit {
    std::uint64_t block;
    std::string name, value;
  };
  struct Candidate {
    Position position;
    Stop stop;
  };

  void work();
  void begin_run();
  void prepare(Chain& chain);

  bool before(const NextBlock& next, StandingRun& run) override;
  void begin(Document& initial, const SymbolTable& symbols) override;
  bool block(Document& document, const SymbolTable& symbols) override;
  bool end() override;
  void add(Diagnostic diagnostic) override;

  bool finish(const BlockEntry& entry);
  void note_entry(const NextBlock& next, StandingRun& run);
  void apply_edits(std::uint64_t number, StandingRun& run);
  void look_up();
  void adopt_table();
  bool is_curious(const BlockEntry& entry) const;
  bool has_breakpoint(const BlockEntry& entry);
  bool consider(const BlockEntry& entry, StandingRun* run);
  bool arrive_quietly(const BlockEntry& entry, StandingRun* run, const Stop& hit);
  Stop hit_at(const BlockEntry& entry);
  Stop hit_by_logic(const BlockEntry& entry, std::uint32_t& done);
  bool is_step_done(const BlockEntry& entry);
  bool stand(const Position& position, const BlockEntry& entry, StandingRun* run, Stop stop);
  void place(const Position& position, const BlockEntry& entry, StandingRun* run, Stop stop);
  bool obey(Step step);
  bool step_within(Step step);
  bool seek(const Position& target, Stop arrival);
  bool look_back(Aim aim);
  std::optional<std::string> assign_here(const std::string& name, const std::string& value);
  Scene scene_of(const BlockEntry& entry, const Stroke* stroke) const;
  bool is_quiet() const { return plan_.aim >= Aim::seek; }

  const DebuggedProgram program_;
  DebugEvents& events_;
  StatementLines statements_;
  const StrokeReader strokes_;
  std::thread thread_;

  // Shared with the thread of the client, under the mutex.
  std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<const BreakpointTable> next_table_;
  bool is_standing_ = false, has_ended_ = false;
  std::optional<Step> command_;
  std::optional<std::pair<std::string, std::string>> assignment_;
  std::optional<std::optional<std::string>> assigned_;
  std::atomic<bool> attention_{false}, pauses_{false};
  std::atomic<bool> leaves_{false};  // the client quits

  // Of the run, on its thread; the client reads them while the run stands.
  Standing standing_;
  std::shared_ptr<const BreakpointTable> table_ = std::make_shared<BreakpointTable>();
  ProgramVariables variables_;
  Plan plan_;
  std::optional<Candidate> candidate_;
  std::vector<Edit> edits_;
  std::size_t next_edit_ = 0;
  std::deque<BlockEntry> entries_;  // begun and not finished; between two blocks the next one is among them
  BlockEntry last_;                 // the one finished last
  std::uint64_t finished_ = 0;
  std::shared_ptr<const Frames> frames_;
  std::uint64_t frames_call_ = 0;
  std::uint32_t frames_pass_ = 0;
  std::map<int, std::uint64_t> hits_;
  std::map<int, bool> was_true_;
  std::optional<Diagnostic> pending_;
  std::string_view break_file_;
  const std::map<std::uint32_t, std::vector<Breakpoint>>* break_lines_ = nullptr;
  std::vector<bool> break_bits_;
  std::vector<Stroke> block_strokes_;
  const Document* document_ = nullptr;
  const SymbolTable* symbols_ = nullptr;
  Chain* chain_ = nullptr;
  std::uint64_t start_block_ = 0;  // that begins at standing_.start
  bool is_editing_ = false, has_start_ = false, runs_again_ = false, has_errors_ = false;
};

}  // namespace isogloss::dap
