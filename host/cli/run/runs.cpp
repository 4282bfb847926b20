#include "run/runs.hpp"

#include "crash_guard.hpp"
#include "dialect_guess.hpp"
#include "isogloss/engine/canonical.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "run/summary_text.hpp"
#include "run_progress.hpp"

namespace isogloss::cli {

namespace {

/// Ends the run when enough errors were reported.
class ErrorLimit : public Exporter {
 public:
  explicit ErrorLimit(const DiagnosticWriter& diagnostics) : diagnostics_(diagnostics) {}
  void begin(Document&, const SymbolTable&) override {}
  bool block(Document& d, const SymbolTable&) override {
    if (!diagnostics_.limit_reached()) [[likely]]
      return true;
    if (last_.line == 0) last_ = {std::string(d.source.file), d.source.line, 0};
    return false;
  }
  bool end() override { return true; }
  /// The block after which the run ended; no line where none was exported after the last error.
  const Location& last() const { return last_; }

 private:
  const DiagnosticWriter& diagnostics_;
  Location last_;
};

std::unique_ptr<Exporter> make_exporter(const RunArguments& c, Output& output, const std::string& dialect,
                                        Session& session) {
  const Format format = c.format == "csv"      ? Format::csv
                        : c.format == "binary" ? Format::binary
                        : c.format == "text"   ? Format::text
                                               : Format::jsonl;
  if (c.emit == "blocks") return make_block_exporter(output, format);
  if (c.emit == "none") return nullptr;
  if (c.emit == "canonical")
    return make_canonical_exporter(output, c.canonical.text, c.canonical.options(c.exact, c.zero_moves),
                                   session.diagnostics());
  return make_motion_exporter(output, {format, c.header, c.zero_moves, c.exact, dialect});
}

/// Where standard error cannot be written, only the exit status can report it.
int print_to_stderr(const std::string& text) {
  const bool is_out = std::fwrite(text.data(), 1, text.size(), stderr) == text.size() && std::fflush(stderr) == 0;
  return is_out ? success : cannot_start;
}

}  // namespace

Runs::~Runs() {
  keep_to_the_end(std::move(linked_));
  for (auto& [name, linked] : likely_) keep_to_the_end(std::move(linked));
}

int Runs::run(const std::string& path) {
  const std::unique_ptr<OpenedProgram> source = OpenedProgram::open(path, session_);
  if (source == nullptr) return cannot_start;
  std::string dialect = request_.program.dialect;
  std::optional<Guess> guess;
  if (dialect.empty()) {
    guess = guess_dialect(path, source->head(), session_);
    if (!guess) return cannot_start;
    dialect = guess->dialect;
  }
  if (linked_ == nullptr || dialect != linked_name_) {
    linked_ = session_.link(dialect, options_.chain.dependencies);
    linked_name_ = dialect;
  }
  if (guess) report_guess(path, *guess, linked_ == nullptr ? "" : parting_of(path, *source, *guess), session_);
  if (linked_ == nullptr) return cannot_start;
  const int status = run_linked(path, *source);
  session_.diagnostics().finish_program();
  return std::max({status, session_.status(), summary_status_});
}

/// How the dialect that is nearly as likely differs, for the note on what was guessed.
std::string Runs::parting_of(const std::string& path, const OpenedProgram& source, const Guess& guess) {
  if (guess.next.empty()) return {};
  auto& next = likely_[guess.next];
  DiagnosticList ignored;
  if (next == nullptr) next = session_.link(guess.next, options_.chain.dependencies, ignored);
  return next == nullptr ? "" : parting(guess, *linked_, *next, path, source.head(), options_);
}

int Runs::run_linked(const std::string& path, OpenedProgram& source) {
  RunOptions options = options_;
  add_program_places(path, linked_->dialect, options);
  show_progress(options, path, session_);

  std::vector<Exporter*> exporters;
  std::unique_ptr<Exporter> totals, tables;
  Summary summary;
  ErrorLimit limit(session_.diagnostics());
  try {
    // One table holds the motions of all programs: its column names, or its header, come once.
    const bool is_one_table = request_.format == "csv" || request_.format == "binary";
    if (data_ == nullptr || !is_one_table) data_ = make_exporter(request_, *output_, linked_->dialect.name, session_);
    if (data_ != nullptr) exporters.push_back(data_.get());
    if (request_.summary) {
      totals = make_summary_exporter(summary, rapid_rates(*linked_, options.chain));
      exporters.push_back(totals.get());
    }
    if (request_.common.maximum_errors != 0) exporters.push_back(&limit);
    options.goes_on = [&] { return request_.budgets.hold(path, session_); };
    if (!request_.tables_to_save.empty())
      exporters.push_back((tables = make_table_saver(request_.tables_to_save, session_)).get());
    const std::uint64_t errors_before = session_.diagnostics().errors();
    const RunResult result = isogloss::run(*linked_, source, path, options, exporters, session_.diagnostics());
    session_.progress().hide();
    wrote_ = true;
    output_is_gone_ = output_->reader_is_gone() || output_->is_over_allowance();
    if (output_->is_over_allowance())
      session_.report("IG-0452", {path, static_cast<std::uint32_t>(result.lines), 0},
                      {std::to_string(request_.budgets.output_bytes)});
    if (session_.diagnostics().limit_reached())
      session_.report("IG-0517", limit.last().line != 0 ? limit.last() : Location{path},
                      {std::to_string(session_.diagnostics().errors())});
    else
      doubt(path, session_.diagnostics().errors() - errors_before, result.blocks);
    if (request_.summary) write_summary(path, summary);
  } catch (const std::runtime_error& e) {
    if (session_.diagnostics().errors() == 0) session_.report("IG-0513", {path}, {e.what()});
    return cannot_start;  // a syntax could not be created; what its exception said may be a fault inside
  }
  return success;
}

/// Errors nearly everywhere have one cause most often.
void Runs::doubt(const std::string& path, std::uint64_t errors, std::uint64_t blocks) {
  constexpr std::uint64_t least = 5;
  if (errors >= least && errors * 4 >= blocks * 3)
    session_.report("IG-0518", {path}, {std::to_string(errors), std::to_string(blocks)});
}

void Runs::write_summary(const std::string& path, const Summary& summary) {
  if (request_.takes_summary) return request_.takes_summary(path, linked_->dialect.name, summary);
  const std::string text =
      (request_.json ? summary_json : summary_text)(path, linked_->dialect.name, summary, session_.diagnostics());
  const bool beside_data = request_.emit != "none" && (request_.output.empty() || request_.output == "-");
  if (beside_data)
    summary_status_ = std::max(summary_status_, print_to_stderr(text));
  else if (request_.output.empty())
    output_->write(text);
  else
    summary_status_ = std::max(summary_status_, print(text, success));
}

}  // namespace isogloss::cli
