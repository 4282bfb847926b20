#include "isogloss/engine/runner.hpp"

#include <algorithm>
#include <utility>

#include "cursor.hpp"
#include "look_ahead_window.hpp"

namespace isogloss {

namespace {

constexpr std::uint32_t widest_column = 65'535;
constexpr std::uint64_t progress_interval = 1u << 16;

bool is_blank(std::string_view text) {
  for (const char c : text)
    if (c != ' ' && c != '\t' && c != '\r') return false;
  return true;
}

class Run {
 public:
  Run(const LinkedDialect& linked, Source& source, const std::string& name, const RunOptions& options,
      const std::vector<Exporter*>& exporters, DiagnosticSink& sink)
      : linked_(linked),
        options_(options),
        exporters_(exporters),
        sink_(sink),
        name_(name),
        chain_(linked, options.chain, sink_),
        cursor_(source, options.maximum_line_bytes),
        length_(static_cast<std::uint32_t>(linked.chain.size())),
        stop_(linked.layout.id("ProgramStop.Term")),
        window_(linked) {}

  RunResult run() {
    if (options_.prepare) options_.prepare(chain_);
    chain_.start();
    for (Exporter* e : exporters_) e->begin(chain_.document(), chain_.symbols());
    if (!options_.program.empty() && !seek_program()) return finish();
    Line line;
    while (!over_ && next_line(line)) run_line(line);
    flush_window();
    if (program_ended_) say_what_follows();
    return finish();
  }

 private:
  bool next_line(Line& line) {
    if (pending_) {
      line = *pending_;
      pending_.reset();
      return true;
    }
    if (!cursor_.next(line)) return false;
    ++result_.lines;
    if (line.number == 1 && cursor_.is_utf16()) {
      sink_.add(host_diagnostic("IG-0413", {name_, 1, 1}, {}));
      return false;
    }
    if (line.truncated) {
      const auto limit = static_cast<std::uint32_t>(options_.maximum_line_bytes);
      sink_.add(host_diagnostic("IG-0403", {name_, line.number, limit + 1}, {std::to_string(limit)}));
    }
    if (line.text.size() > widest_column && !said_wide_) {
      said_wide_ = true;
      sink_.add(host_diagnostic("IG-0404", {name_, line.number, widest_column}, {std::to_string(widest_column)}));
    }
    return true;
  }

  /// Reads on to the block that begins the program asked for; nothing before it is executed or reported.
  bool seek_program() {
    const ig_field program = linked_.layout.id("Source.Program");
    DiagnosticList ignored;
    Chain scout(linked_, options_.chain, ignored);
    scout.start();
    Line line;
    while (next_line(line)) {
      scout.begin_block({name_, line.number, 0, line.text});
      scout.scan();
      if (scout.document().text(program) == options_.program) {
        pending_ = line;
        return true;
      }
    }
    sink_.add(host_diagnostic("IG-0406", {name_, 0, 0}, {options_.program}));
    return false;
  }

  void run_line(const Line& line) {
    std::size_t offset = 0;
    do {
      const std::string_view rest = line.text.substr(offset);
      if (is_blank(rest)) return;
      chain_.begin_block({name_, line.number, static_cast<std::uint32_t>(offset), rest});
      const std::size_t end = chain_.scan();
      if (end < rest.size()) chain_.document().source.text = rest.substr(0, end);
      run_block();
      offset += std::max<std::size_t>(end, 1);
    } while (!over_ && offset < line.text.size());
    if (options_.stop_after_line != 0 && line.number >= options_.stop_after_line && window_.is_empty()) over_ = true;
  }

  void run_block() {
    ++result_.blocks;
    Document& d = chain_.document();
    const bool waits = execute(d);
    if (chain_.alarmed) answer_alarm(d);
    if (chain_.ends_program || chain_.ends_file) {
      over_ = true;
      program_ended_ = chain_.ends_program && !chain_.ends_file;
    }
    if (options_.maximum_blocks != 0 && result_.blocks >= options_.maximum_blocks && !over_) {
      over_ = true;
      chain_.report(d, Severity::error, "IG-0407",
                    host_diagnostic("IG-0407", {}, {std::to_string(result_.blocks)}).message, 0, 0);
    }
    if (waits) keep_in_window(d);
    if (options_.progress && result_.blocks % progress_interval == 0)
      options_.progress(result_.blocks, cursor_.bytes());
  }

  void export_block(Document& d) {
    for (Exporter* e : exporters_)
      if (!e->block(d, chain_.symbols())) {
        result_.output_closed = true;
        over_ = true;
      }
  }

  /// To its end; or to where it has to wait for the blocks after it, which is true.
  bool execute(Document& d) {
    if (!window_.is_empty()) {
      chain_.run(d, 0, linked_.post_logic_begin);
      return true;
    }
    chain_.run(d, 0, length_);
    if (chain_.waits_at != 0) return true;
    export_block(d);
    return false;
  }

  void answer_alarm(const Document& d) {
    if (options_.stop_on_error) {
      result_.stopped_by_alarm = over_ = true;
      return;
    }
    const Diagnostic text = host_diagnostic("IG-0408", {}, {});
    chain_.report(d, text.severity, text.code, text.message, 0, 0);
  }

  // Executed blocks wait until the ones are there that they want to see; post-logic, inspection and export follow.
  void keep_in_window(const Document& d) {
    window_.add(d, window_.is_empty() ? chain_.waits_at : linked_.post_logic_begin, sink_.take());
    sink_.hold();
    const bool stops = d.fresh(stop_);
    while (!window_.is_empty() && (stops || window_.is_complete())) finish_oldest();
  }

  void finish_oldest() {
    LookAheadWindow::Entry& oldest = window_.oldest();
    const std::vector<Diagnostic> later = sink_.take();
    sink_.pass_on();
    for (const Diagnostic& d : oldest.said) sink_.add(d);
    window_.show(chain_.window);
    const bool newest_alarmed = std::exchange(chain_.alarmed, false);
    chain_.waits_at = 0;
    chain_.run(oldest.document, oldest.resume_at, length_);
    export_block(oldest.document);
    const bool alarmed = std::exchange(chain_.alarmed, newest_alarmed);
    if (alarmed) answer_alarm(oldest.document);
    chain_.window.clear();
    window_.drop_oldest();
    if (alarmed && options_.stop_on_error) window_.clear();  // what the control has read ahead it does not execute
    if (window_.is_empty()) return;
    sink_.hold();
    for (const Diagnostic& d : later) sink_.add(d);
  }

  void flush_window() {
    while (!window_.is_empty() && !result_.output_closed) finish_oldest();
    sink_.pass_on();
  }

  /// Text behind the end of the program is not run; that is said once.
  void say_what_follows() {
    Line line;
    while (cursor_.next(line)) {
      const std::size_t first = line.text.find_first_not_of(std::string_view(" \t\r\0\x1a%", 6));
      if (first == std::string_view::npos) continue;
      sink_.add(host_diagnostic("IG-0414", {name_, line.number, static_cast<std::uint32_t>(first + 1)}, {}));
      return;
    }
  }

  RunResult finish() {
    for (Exporter* e : exporters_)
      if (!e->end()) result_.output_closed = true;
    result_.bytes = cursor_.bytes();
    return result_;
  }

  const LinkedDialect& linked_;
  const RunOptions& options_;
  const std::vector<Exporter*>& exporters_;
  OrderedDiagnostics sink_;
  std::string name_;
  Chain chain_;
  Cursor cursor_;
  std::uint32_t length_;
  RunResult result_;
  std::optional<Line> pending_;
  ig_field stop_;
  LookAheadWindow window_;
  bool over_ = false, program_ended_ = false, said_wide_ = false;
};

}  // namespace

RunResult run(const LinkedDialect& linked, Source& source, const std::string& name, const RunOptions& options,
              const std::vector<Exporter*>& exporters, DiagnosticSink& sink) {
  return Run(linked, source, name, options, exporters, sink).run();
}

}  // namespace isogloss
