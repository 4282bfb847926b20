/// A chain at work: instances of the syntaxes, their tables, one document. Belongs to one thread and one run.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <unordered_map>

#include "isogloss/engine/document.hpp"
#include "isogloss/engine/linker.hpp"
#include "isogloss_flow.h"
#include "isogloss_provenance.h"

namespace isogloss {

class FlowHost;
class LinePlaces;
struct LineNotes;
struct ScannedLine;

enum class Mode { fast, checked, traced };

/// The functions that this host gives to the syntaxes of a chain, and to create().
const ig_host& host_table(Mode mode);
const ig_link_api& link_api();

/// A dependency's data, cloned for each run.
class DependencyTable {
 public:
  explicit DependencyTable(const ig_dependency& dependency) : dependency_(&dependency) {}
  std::optional<std::size_t> column(std::string_view name) const;
  std::optional<double> value(std::string_view row, std::uint32_t column) const;
  std::string_view text(std::string_view row, std::uint32_t column) const;
  /// A row with the columns' defaults, unless there is one of that name.
  void add(std::string_view name) { row(name); }
  /// False when the column does not exist or the value is out of its range.
  bool set(std::string_view row, std::uint32_t column, std::string_view text);
  bool set(std::string_view row, std::uint32_t column, double value);
  void add_row(std::string_view name) { row(name); }
  const ig_dependency& dependency() const { return *dependency_; }
  const std::vector<std::string>& rows() const { return names_; }
  /// Called for each value that is asked for: the row, and whether it has the value. Empty: nobody listens.
  using Listener = std::function<void(std::string_view row, bool has_value)>;
  void listen(Listener listener) { listener_ = std::move(listener); }

 private:
  struct Cell {
    std::string text;
    double number = 0;
    bool has_value = false;
  };
  std::vector<Cell>& row(std::string_view name);
  const ig_dependency* dependency_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t, TextHash, std::equal_to<>> index_;
  std::vector<std::vector<Cell>> cells_;
  Listener listener_;
};

struct ChainSettings {
  Mode mode = Mode::fast;
  bool hears_rows = false;  ///< rows that are asked when the syntaxes are created are kept, too (Chain::rows_at_start)
  bool call_all = false;    ///< call every syntax in every block: must give the same result
  std::map<std::string, std::string, std::less<>> settings;      ///< "block-skip", "optional-stop", "program"
  std::vector<DependencyElement> dependencies;                   ///< the user's own tables, before the dialect's
  std::vector<std::pair<std::string, std::string>> assignments;  ///< --set: "Offsets.2.Z", "-120"
  /// In place of host_table(mode) and link_api(): a host of another version. They outlive the chain.
  const ig_host* host = nullptr;
  const ig_link_api* link_api = nullptr;
};

/// Where the run is, for a crash report. Plain data that a signal handler may read.
struct Breadcrumb {
  const char* plugin = nullptr;
  const char* syntax = nullptr;
  const char* phase = nullptr;         ///< the function of the contract that is at work: "create", "build" …
  const Document* document = nullptr;  ///< null outside the blocks of a run
};

class Chain {
 public:
  /// Another chain works while a block of this one does: afterwards the block of the outer chain is at work again.
  class Interlude {
   public:
    Interlude();
    ~Interlude();
    Interlude(const Interlude&) = delete;
    Interlude& operator=(const Interlude&) = delete;

   private:
    const Document* before_;
  };

  /// Throws std::runtime_error when a syntax cannot be created; the diagnostics say which and why.
  Chain(const LinkedDialect& linked, ChainSettings settings, DiagnosticSink& sink);
  ~Chain();
  Chain(const Chain&) = delete;
  Chain& operator=(const Chain&) = delete;

  const LinkedDialect& linked() const { return linked_; }
  Document& document() { return document_; }
  SymbolTable& symbols() { return symbols_; }
  DiagnosticSink& sink() { return sink_; }
  const ig_host& host() const { return *host_; }

  /// The block before the first: initial fields, then every restart(). One of them may end the file, and so the run,
  /// before it begins.
  void start(std::string_view file = {});
  /// The document starts a block of this text.
  void begin_block(const BlockSource& source);
  /// Asks the scanners; returns the end of the block in the text (a scanner may split the line).
  std::size_t scan();
  /// Gives the block what its scanners have found ahead of its turn. False where it is not what they would find now:
  /// the block is as it was.
  bool take_scanned(const ScannedLine& line);
  /// Where a chain that scans ahead notes what it finds.
  LineNotes* notes = nullptr;
  /// Calls the syntaxes in chain positions [first, last) that are awake.
  void run(Document& document, std::uint32_t first, std::uint32_t last) {
    if (first == 0 && last == steps_.size() && is_plain_) [[likely]]
      run_whole(document);
    else
      run_part(document, first, last);
  }
  /// One build() of one syntax on the document as it is.
  ig_status build(std::uint32_t position);
  /// run() calls the syntax there, which has a build().
  void wake(Document& document, std::size_t position) const;
  /// Whether something woke the syntax there. With call_all run() calls the others as well.
  bool is_awake(const Document& document, std::size_t position) const;
  std::size_t scan_with(std::uint32_t position);  ///< one scanner alone over the whole text

  /// Called before and after each build() in traced mode.
  std::function<void(std::uint32_t position, bool before)> trace;
  /// Called for each piece of text that a scanner has read; empty: none.
  std::function<void(std::uint32_t position, std::size_t begin, std::size_t end)> scanned;
  /// The file of this number in Document::Origin; traced mode only.
  std::string_view file_name(std::uint16_t number) const {
    return number < files_.size() ? files_[number] : std::string_view();
  }

  // Requests of syntaxes in this block.
  bool ends_program = false, ends_file = false, alarmed = false, skip_rest = false;
  /// Chain position of a syntax that looks ahead and that run() came to before the stage of such syntaxes began, or
  /// before the window held enough for it: the block has to wait for those after it. 0: none; the owner of the window
  /// resets it.
  std::uint32_t waits_at = 0;
  /// Chain position + 1 of the syntax that reported its failure; the host reports a failure without a reason.
  std::uint16_t failure_said_by = 0;
  std::size_t split_at = 0;
  std::uint64_t builds = 0;   ///< builds called so far
  std::uint64_t blocks = 0;   ///< blocks begun so far
  std::uint64_t records = 0;  ///< records added to lists so far: steps of cycles

  /// A row of a table that has answered for this block.
  struct AnsweredRow {
    std::uint16_t syntax;  ///< chain position + 1
    std::size_t dependency;
    std::string row;
    bool operator==(const AnsweredRow&) const = default;
  };
  /// Those of this block, in their order, at most most_answered_rows; empty unless listen_to_rows() was called.
  std::vector<AnsweredRow> answered_rows;
  static constexpr std::size_t most_answered_rows = 1000;
  /// Those that have answered when the syntaxes were created, where the settings want it.
  std::vector<AnsweredRow> rows_at_start;
  /// Called for each row that is asked, answered or not; empty: none.
  std::function<void(std::size_t dependency, std::string_view row)> row_asked;
  void listen_to_rows();
  /// Called for each variable that a syntax has read or written, after listen_to_rows(); empty: none.
  std::function<void(const Document&, bool is_write, std::string_view name, std::uint64_t scope, const ig_argument*)>
      variable_used;
  /// Called for each condition that a syntax has examined, after listen_to_rows(), with its IG_CONDITION_...; empty:
  /// none.
  std::function<void(const Document&, std::string_view text, std::uint32_t outcome)> condition_examined;
  /// What the cell means to people, where the dependency says so (isogloss.row-meaning/1).
  std::optional<ig_row_meaning> meaning_of(std::size_t dependency, const std::string& row, const char* column) const;
  /// A row of the table has been asked by the syntax at work, and has a value for it or not.
  void note_row(std::size_t dependency, std::string_view row, bool has_value);

  /// Executes calls and jumps, set by the runner; null where no program runs.
  FlowHost* flow = nullptr;
  /// From now on scanners report the names of lines.
  void collect_labels() { flow_service_.is_indexing = 1; }

  void report(const Document& document, Severity severity, std::string_view code, std::string message,
              std::uint32_t begin, std::uint32_t end, std::string hint = {});
  const void* service(std::string_view id) const;
  /// The dependency that answers for a service, by its place in the dialect.
  std::optional<std::size_t> answering(std::string_view id) const;
  DependencyTable* table(std::string_view dependency);
  std::string_view setting(std::string_view name) const;

  /// The window of executed blocks ahead of a post-logic document, set by the runner.
  std::vector<Document*> window;
  /// More may come: a syntax that the window is too short for has to wait.
  bool window_grows = false;

  static const Breadcrumb& breadcrumb();

 private:
  /// A field whose presence wakes syntaxes, or its copy from before the block.
  struct Watch {
    ig_field field;
    std::uint32_t begin, end;  // of what it wakes, in watched_
    bool is_modal;
    std::uint64_t awake[most_wake_words];  // what its present value wakes
  };

  void place_in_joined(const Document& d, std::uint32_t begin, std::uint32_t end, Diagnostic& out);
  const ig_link_api& link_functions() const {
    return settings_.link_api != nullptr ? *settings_.link_api : isogloss::link_api();
  }
  void create_dependencies();
  void create_syntaxes();
  void watch_modal_state();
  void look_at_state();
  void look_at(Watch& watch, std::uint64_t change);
  /// A bit of Document::changes; the watches beyond share the last one.
  static constexpr std::size_t last_change = 63;
  static std::uint64_t change_of(std::size_t watch) { return std::uint64_t{1} << std::min(watch, last_change); }
  void overlay(const DependencyElement& element);
  void assign(const std::string& path, const std::string& value);
  void refuse_rows(std::size_t dependency);
  void check_answers();
  void report_idle_rows();
  /// Syntaxes, as in Document::active.
  struct Reach {
    std::uint64_t words[most_wake_words];
    void add(std::size_t bit) {
      words[bit / 64] |= std::uint64_t{1} << (bit % 64);
      if (bit >= 128) words[1] |= wakes_beyond;
    }
  };
  void call_watched(Document& document, std::uint32_t position);  // checked and traced modes
  bool call_looking_ahead(Document& document, std::uint32_t position, std::uint32_t first);
  bool sees_enough(std::uint32_t position) const;
  void inspect(Document& document, std::uint32_t first, std::uint32_t last);
  void run_range(Document& document, std::uint32_t first, std::uint32_t last);
  void run_whole(Document& document);
  void run_part(Document& document, std::uint32_t first, std::uint32_t last);
  template <bool is_plain>
  void call_steps(Document& document, std::uint32_t begin, const Reach& reach);
  Reach reach(std::uint32_t first, std::uint32_t last) const;
  void leave_byte(Document& document, std::size_t position);
  bool has_read_values(const ScannedLine& line) const;
  void tell_failure(const Document& document, std::uint32_t position);
  void tell_exception(const Document& document, const char* phase);
  template <bool is_heard>
  void scan_from(std::size_t& position);
  std::uint16_t file_number(std::string_view file);
  std::size_t refuse_end(std::size_t at);
  void destroy_part(const ig_plugin& plugin, const std::string& alias, void (*destroy)(void*), void* self);
  void destroy();

  const LinkedDialect& linked_;
  ChainSettings settings_;
  DiagnosticSink& sink_;
  std::unique_ptr<LinePlaces> joined_;  // of the block, once it needs them
  SymbolTable symbols_;
  Document document_;
  std::uint64_t reports_ = 0;  // diagnostics of this chain so far
  const ig_host* host_;
  ig_flow_1 flow_service_;
  ig_provenance_1 provenance_;
  struct Step {
    ig_run_fn build = nullptr;  // of a syntax that looks ahead this is null ...
    ig_scan_fn scan = nullptr;
    void* self = nullptr;
    ig_run_fn build_ahead = nullptr;  // ... and its build() stands here
    ig_run_fn any_build() const { return build != nullptr ? build : build_ahead; }
  };
  std::vector<WakeWhile> watched_;  // by field
  std::vector<Watch> watches_;
  std::uint64_t awake_by_state_[most_wake_words] = {};    // all of them together
  std::uint64_t awake_by_rest_[most_wake_words] = {};     // all but those that changed last
  std::uint64_t changing_ = 0;                            // of Document::changes: those
  std::uint64_t passing_ = 0;                             // of Document::changes: the values that end with this block
  std::uint64_t always_ = 0;                              // ... and those whose writes bypass tell_watch
  std::vector<Step> steps_;                               // by chain position
  std::vector<std::unique_ptr<DependencyTable>> tables_;  // by linked dependency, as the two below
  std::vector<std::vector<OptionValue>> dependency_options_;
  std::vector<void*> dependencies_;
  std::vector<std::string_view> files_;            // of the blocks so far; traced mode only
  std::vector<std::uint16_t> scanners_[256];       // chain positions that a byte triggers
  Reach before_inspection_{}, from_inspection_{};  // on both sides of inspection_begin
  Reach inspection_{};                             // from there on, those that build
  Reach inspectors_{};                             // of these, what runs when something is left over
  const bool is_plain_;
  struct AssignedRow {
    std::size_t dependency;
    std::string name;
    std::uint32_t column;
  };
  std::vector<AssignedRow> assigned_rows_;  // by --set
  bool is_scanning_ = false;                // for a crash report
  std::uint16_t creating_ = 0;              // chain position + 1 of the syntax that is being created
};

}  // namespace isogloss
