#include "isogloss/engine/runner.hpp"

#include <algorithm>
#include <cfenv>
#include <memory>
#include <thread>
#include <utility>

#include "document/finite_values.hpp"
#include "isogloss/engine/stepping.hpp"
#include "run/flow.hpp"
#include "run/look_ahead_window.hpp"
#include "run/scan_ahead.hpp"

namespace isogloss {

namespace {

constexpr std::uint32_t widest_column = 65'535;
constexpr std::uint64_t progress_interval = 1u << 16;

bool holds_no_word(std::string_view text) {
  for (const char c : text)
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') return false;
  return true;
}

class Run final : StandingRun {
 public:
  Run(const LinkedDialect& linked, Source& source, const std::string& name, const RunOptions& options,
      const std::vector<Exporter*>& exporters, DiagnosticSink& sink)
      : linked_(linked),
        options_(options),
        exporters_(exporters),
        sink_(sink),
        chain_(linked, options.chain, sink_),
        flow_(linked, source, name, options, sink_),
        length_(static_cast<std::uint32_t>(linked.chain.size())),
        stop_(linked.layout.id("ProgramStop.Term")),
        end_(linked.layout.id("Source.~End")),
        finite_(linked.layout),
        window_(linked, chain_) {
    chain_.flow = &flow_;
  }

  RunResult run() {
    if (options_.prepare) options_.prepare(chain_);
    chain_.start(flow_.file_name());
    for (Exporter* e : exporters_) e->begin(chain_.document(), chain_.symbols());
    if (chain_.ends_file) return finish();
    if (!options_.program.empty() && !flow_.select_program(options_.program)) {
      sink_.add(host_diagnostic("IG-0406", {flow_.file_name(), 0, 0}, {options_.program}));
      return finish();
    }
    Line line;
    while (!over_) {
      if (next_line(line)) {
        if (result_.lines >= scan_ahead_from_ && flow_.depth() == 0) [[unlikely]]
          scan_ahead();
        run_line(line);
      } else if (!flow_.is_over() && !flow_.leave_at_end(chain_.document()))
        over_ = text_ended_ = true;
      over_ = over_ || flow_.is_over() || (is_line_done_ && window_.is_empty());
    }
    flush_window();
    if (is_utf16_) return finish();
    if (text_ended_ && result_.blocks == 0) sink_.add(host_diagnostic("IG-0423", {flow_.file_name(), 0, 0}, {}));
    if (text_ended_) run_end();
    if (program_ended_ || text_ended_) report_what_follows();
    return finish();
  }

 private:
  bool next_line(Line& line) {
    Cursor& cursor = flow_.cursor();
    if (ahead_ != nullptr && cursor.source() == scanned_ahead_) {
      found_ = ahead_->next_at(cursor.offset());
      if (found_ != nullptr && found_->size <= widest_column && cursor.next(line, found_->size)) {
        ahead_->take(*found_);
        ++result_.lines;
        return true;
      }
      found_ = nullptr;
    }
    const bool has_line = cursor.next(line);
    if (cursor.has_failed()) [[unlikely]] {
      flow_.fail_to_read(cursor.next_number() - (has_line ? 1 : 0));
      return false;
    }
    if (!has_line) return false;
    ++result_.lines;
    if (line.number == 1 && cursor.is_utf16()) {
      sink_.add(host_diagnostic("IG-0413", {flow_.file_name(), 1, 1}, {}));
      is_utf16_ = true;
      return false;
    }
    if (line.truncated) {
      const auto limit = static_cast<std::uint32_t>(options_.maximum_line_bytes);
      sink_.add(host_diagnostic("IG-0403", {flow_.file_name(), line.number, limit + 1}, {std::to_string(limit)}));
    }
    if (line.text.size() > widest_column && !reported_wide_) {
      reported_wide_ = true;
      sink_.add(
          host_diagnostic("IG-0404", {flow_.file_name(), line.number, widest_column}, {std::to_string(widest_column)}));
    }
    return true;
  }

  void run_line(const Line& line) {
    const std::string_view file = flow_.file_name();
    std::size_t offset = std::min<std::size_t>(flow_.take_column(), line.text.size());
    bool has_run = false;
    do {
      const std::string_view rest = line.text.substr(offset);
      if (holds_no_word(rest)) break;
      const auto column = static_cast<std::uint32_t>(offset);
      if (flow_.take_passing()) {
        offset += std::max<std::size_t>(flow_.block_end(rest), 1);
        continue;
      }
      flow_.at({line.offset, column, line.number});
      if (flow_.is_over()) return;
      const BlockSource source = source_of(line, file, column, rest);
      if (options_.listener != nullptr && !goes_on_with(source)) [[unlikely]]
        return;
      chain_.begin_block(source);
      const std::size_t end = scan(line, rest);
      if (end < rest.size()) chain_.document().source.text = rest.substr(0, end);
      run_block();
      has_run = true;
      offset += std::max<std::size_t>(end, 1);
      if (flow_.has_request()) {
        const BlockPlace next = place_behind(line, offset);
        if (holds_last(line) && next.column == 0) count_pass(file);
        if (!over_) flow_.perform(chain_.document(), next);
        return;
      }
    } while (!over_ && offset < line.text.size());
    if (holds_last(line) && has_run && !has_more(line, offset)) count_pass(file);
  }

  /// Returns the end of the block in the text, which is the line's from some byte on.
  [[gnu::always_inline]] inline std::size_t scan(const Line& line, std::string_view text) {
    if (ahead_ != nullptr && text.size() == line.text.size() && flow_.cursor().source() == scanned_ahead_) {
      if (const ScannedLine* const found = found_ != nullptr ? found_ : ahead_->find(line)) {
        if (chain_.take_scanned(*found)) {
          refused_ = 0;
          return text.size();
        }
        if (++refused_ == most_refused) [[unlikely]]
          ahead_.reset();
      }
    }
    return chain_.scan();
  }

  /// The main program, where a processor may be free, and nobody has to hear of the scanners.
  [[gnu::cold, gnu::noinline]] void scan_ahead() {
    scan_ahead_from_ = never;
    if (std::thread::hardware_concurrency() < 2 || options_.chain.mode != Mode::fast || options_.chain.call_all ||
        options_.chain.host != nullptr || options_.listener != nullptr || chain_.scanned)
      return;
    const Source* const source = flow_.cursor().source();
    std::unique_ptr<Source> again = source->again();
    if (again == nullptr) return;
    try {
      ahead_ = std::make_unique<ScanAhead>(linked_, options_, std::move(again), flow_.file_name());
      scanned_ahead_ = source;
    } catch (const std::exception&) {  // no thread: the run scans by itself
    }
  }

  /// Asks the listener; false when the run ends before the block.
  [[gnu::noinline]] bool goes_on_with(const BlockSource& source) {
    NextBlock next{.number = result_.blocks + 1,
                   .file = source.file,
                   .line = source.line,
                   .column = source.column,
                   .depth = flow_.depth(),
                   .call = flow_.call(),
                   .pass = flow_.pass(),
                   .text = source.text,
                   .waiting = window_.size()};
    if (source.is_joined) next.lines += LinePlace::of(source.text, source.text.size()).line;
    if (options_.listener->before(next, *this)) return true;
    over_ = true;
    return false;
  }

  std::vector<ExplainedFrame> frames() const override {
    std::vector<ExplainedFrame> out;
    ig_frame f{};
    f.struct_size = sizeof f;
    for (std::uint32_t level = 0; flow_.frame(level, f); ++level)
      out.push_back({std::string(f.file.data, f.file.size), std::string(f.program.data, f.program.size), f.call_line,
                     f.pass, f.passes, f.id});
    return out;
  }

  Chain& chain() override { return chain_; }

  std::vector<Diagnostic> execute(std::string_view block) override {
    const bool was_holding = sink_.is_holding();
    std::vector<Diagnostic> held = sink_.take();
    sink_.hold();
    Document& d = chain_.document();
    const std::uint32_t line = d.source.line;
    chain_.begin_block({flow_.file_name(), line, 0, block, false});
    if (const std::size_t end = chain_.scan(); end < block.size()) d.source.text = block.substr(0, end);
    chain_.run(d, 0, linked_.post_logic_begin);
    chain_.waits_at = 0;
    chain_.run(d, linked_.inspection_begin, length_);
    flow_.drop_request();
    chain_.ends_program = chain_.ends_file = chain_.alarmed = false;
    d.own_source();
    std::vector<Diagnostic> said = sink_.take();
    if (!was_holding) sink_.pass_on();
    for (Diagnostic& before : held) sink_.add(std::move(before));
    return said;
  }

  static BlockSource source_of(const Line& line, std::string_view file, std::uint32_t column, std::string_view text) {
    BlockSource source{file, line.number, column, text, line.lines > 1};
    if (source.is_joined && column > 0) {
      const LinePlace place = LinePlace::of(line.text, column);
      source.line += place.line;
      source.column = static_cast<std::uint32_t>(column - place.begin);
    }
    return source;
  }

  /// Is the line at which the run stops one of these?
  bool holds_last(const Line& line) const { return options_.stop_after_line - line.number < line.lines; }

  /// Where the run continues after a block that ends at this column.
  BlockPlace place_behind(const Line& line, std::size_t column) {
    if (has_more(line, column)) return {line.offset, static_cast<std::uint32_t>(column), line.number};
    return {flow_.cursor().offset(), 0, line.number + line.lines};
  }

  static bool has_more(const Line& line, std::size_t column) {
    return column < line.text.size() && !holds_no_word(line.text.substr(column));
  }

  /// A pass over the line at which the run stops is done; blocks that wait for others may still be under way.
  void count_pass(std::string_view file) {
    if (!flow_.is_file(file, options_.stop_in_file) || ++passes_ < options_.stop_after_pass) return;
    is_line_done_ = true;
    over_ = over_ || window_.is_empty();
  }

  void run_block() {
    ++result_.blocks;
    Document& d = chain_.document();
    const bool waits = execute(d);
    if (chain_.alarmed && !waits) answer_alarm(d);
    if (chain_.alarmed && options_.stop_on_error) over_ = true;
    if (chain_.ends_program || chain_.ends_file) {
      program_ended_ = chain_.ends_program && !chain_.ends_file;
      // The text of a called program may end, the program as a whole does not.
      text_ended_ = !over_ && !chain_.ends_program && !flow_.has_request() && !flow_.request_end(d);
      over_ = over_ || chain_.ends_program || text_ended_;
    }
    if (result_.blocks + chain_.records >= next_look_) [[unlikely]]
      look_at_limits(d);
    if (waits) keep_in_window(d);
    if (result_.blocks % progress_interval == 0) [[unlikely]]
      show_progress();
  }

  /// Reports a limit that is reached, and sets the sum of blocks and records at which the next look is due: before it,
  /// neither limit can be reached.
  [[gnu::cold, gnu::noinline]] void look_at_limits(const Document& d) {
    const std::uint64_t motions = result_.blocks + chain_.records;
    if (motions > options_.maximum_motions && !over_) {
      over_ = true;
      chain_.report(d, Severity::error, "IG-0455",
                    host_diagnostic("IG-0455", {}, {std::to_string(options_.maximum_motions)}).message, 0, 0);
    }
    if (options_.maximum_blocks != 0 && result_.blocks >= options_.maximum_blocks && !over_) {
      over_ = true;
      chain_.report(d, Severity::error, "IG-0407",
                    host_diagnostic("IG-0407", {}, {std::to_string(result_.blocks)}).message, 0, 0);
    }
    std::uint64_t left = options_.maximum_motions - std::min(motions, options_.maximum_motions);
    if (options_.maximum_blocks != 0)
      left = std::min(left, options_.maximum_blocks - std::min(result_.blocks, options_.maximum_blocks));
    next_look_ = motions + std::max<std::uint64_t>(left, 1);
  }

  [[gnu::cold, gnu::noinline]] void show_progress() {
    if (options_.progress) options_.progress(result_.blocks, flow_.bytes());
    over_ = over_ || (options_.goes_on && !options_.goes_on());
  }

  [[gnu::always_inline]] inline void export_block(Document& d) {
    for (Exporter* e : exporters_)
      if (!e->block(d, chain_.symbols())) {
        result_.output_closed = true;
        over_ = true;
      }
  }

  /// Runs the block to its end; true when it has to wait for the blocks after it.
  [[gnu::always_inline]] inline bool execute(Document& d) {
    if (!window_.is_empty()) {
      chain_.run(d, 0, linked_.post_logic_begin);
      return is_finite(d, Inspection::missing);
    }
    chain_.run(d, 0, length_);
    if (!is_finite(d, chain_.waits_at == 0 ? Inspection::done : Inspection::missing)) return false;
    if (chain_.waits_at != 0) return true;
    export_block(d);
    return false;
  }

  /// No value that overflowed leaves the run: nothing after it can be right.
  enum class Inspection : std::uint8_t { done, missing };
  bool is_finite(Document& d, Inspection inspection) { return !finite_.is_suspect(d) || !tell_overflow(d, inspection); }

  /// Reports the same about a block whether it had to wait for others or not.
  [[gnu::cold]] bool tell_overflow(Document& d, Inspection inspection) {
    const std::string path = finite_.find_overflow(d);
    if (path.empty()) return false;
    over_ = true;
    chain_.waits_at = 0;
    if (inspection == Inspection::missing) chain_.run(d, linked_.inspection_begin, length_);
    const Diagnostic text = host_diagnostic("IG-0430", {}, {path});
    chain_.report(d, text.severity, text.code, text.message, 0, 0);
    return true;
  }

  void answer_alarm(const Document& d) {
    if (options_.stop_on_error) {
      result_.stopped_by_alarm = over_ = true;
      return;
    }
    const Diagnostic text = host_diagnostic("IG-0408", {}, {});
    chain_.report(d, text.severity, text.code, text.message, 0, 0);
  }

  // Executed blocks wait until the blocks that they read are present; post-logic, inspection and export follow.
  void keep_in_window(const Document& d) {
    const std::uint32_t resume_at = window_.is_empty() ? chain_.waits_at : linked_.post_logic_begin;
    window_.add(d, resume_at, sink_.take()).alarmed = chain_.alarmed;
    sink_.hold();
    const bool stops = d.fresh(stop_);
    while (!window_.is_empty() && (stops || window_.is_complete()))
      if (!finish_oldest(!stops)) break;
  }

  /// False where a syntax that the block now came to has to wait for more blocks, as long as the window grows.
  bool finish_oldest(bool window_grows) {
    LookAheadWindow::Entry& oldest = window_.oldest();
    const std::vector<Diagnostic> later = sink_.take();
    sink_.pass_on();
    for (const Diagnostic& d : std::exchange(oldest.said, {})) sink_.add(d);
    const std::span<Document* const> following = window_.following();
    chain_.window.assign(following.begin(), following.end());
    chain_.alarmed = oldest.alarmed;
    chain_.waits_at = 0;
    chain_.window_grows = window_grows;
    chain_.run(oldest.document, oldest.resume_at, length_);
    if (chain_.waits_at != 0) {
      oldest.resume_at = std::exchange(chain_.waits_at, 0);
      oldest.alarmed = chain_.alarmed;
      chain_.window.clear();
      sink_.hold();
      for (const Diagnostic& d : later) sink_.add(d);
      return false;
    }
    const bool is_sound = is_finite(oldest.document, Inspection::done);
    if (is_sound) export_block(oldest.document);
    if (chain_.alarmed) answer_alarm(oldest.document);
    chain_.window.clear();
    window_.drop_oldest();
    if (!is_sound || (chain_.alarmed && options_.stop_on_error)) {
      window_.clear();  // the control does not execute blocks that it has only read ahead
      return true;
    }
    if (!window_.is_empty()) sink_.hold();
    for (const Diagnostic& d : later) sink_.add(d);  // reported between two blocks, after the last one that waits
    return true;
  }

  void flush_window() {
    while (!window_.is_empty() && !result_.output_closed) finish_oldest(false);
    sink_.pass_on();
  }

  /// The main program's text ended and no block ended the program: syntaxes may report that. This
  /// is no block of the program and reaches no exporter.
  void run_end() {
    if (end_ == IG_NO_FIELD || result_.blocks == 0 || result_.output_closed) return;
    chain_.begin_block({flow_.file_name(), flow_.cursor().next_number() - 1, 0, {}, false});
    chain_.document().set(end_, {.integer = 1});
    chain_.run(chain_.document(), 0, linked_.post_logic_begin);
  }

  /// Text after the end of the program that no call or jump reached is reported once.
  void report_what_follows() {
    if (const auto first = flow_.first_not_run())
      sink_.add(host_diagnostic("IG-0414", {flow_.file_name(), first->line, first->column + 1}, {}));
  }

  RunResult finish() {
    for (Exporter* e : exporters_)
      if (!e->end()) result_.output_closed = true;
    result_.bytes = flow_.bytes();
    result_.jumps = flow_.jumps();
    return result_;
  }

  const LinkedDialect& linked_;
  const RunOptions& options_;
  const std::vector<Exporter*>& exporters_;
  OrderedDiagnostics sink_;
  Chain chain_;
  Flow flow_;
  std::uint32_t length_;
  RunResult result_;
  std::uint64_t passes_ = 0;
  std::uint64_t next_look_ = 0;
  bool is_line_done_ = false;
  ig_field stop_, end_;
  FiniteValues finite_;
  LookAheadWindow window_;
  bool over_ = false, program_ended_ = false, text_ended_ = false, reported_wide_ = false, is_utf16_ = false;
  static constexpr std::uint64_t never = UINT64_MAX;
  std::uint64_t scan_ahead_from_ = options_.scans_ahead_after == 0 ? never : options_.scans_ahead_after;
  const Source* scanned_ahead_ = nullptr;
  std::unique_ptr<ScanAhead> ahead_;
  const ScannedLine* found_ = nullptr;  ///< of the line that next_line() gave, where that has looked
  static constexpr std::uint32_t most_refused = 16 * 1024;  // in a row: what the scanners read stays another
  std::uint32_t refused_ = 0;
};

}  // namespace

RunResult run(const LinkedDialect& linked, Source& source, const std::string& name, const RunOptions& options,
              const std::vector<Exporter*>& exporters, DiagnosticSink& sink) {
  // Not on the stack: a plugin that writes beyond its own frame must leave the report of its fault something to read.
  return std::make_unique<Run>(linked, source, name, options, exporters, sink)->run();
}

}  // namespace isogloss
