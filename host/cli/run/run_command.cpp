// The main job: programs in, motions or blocks out.
#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <map>

#include "canonical_text.hpp"
#include "crash_guard.hpp"
#include "dialect_guess.hpp"
#include "isogloss/engine/canonical.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "program_options.hpp"
#include "reproducer.hpp"
#include "run/run_budgets.hpp"
#include "run/summary_text.hpp"
#include "table_saver.hpp"

namespace isogloss::cli {

namespace {

struct RunCommand {
  CommonOptions common;
  ProgramOptions program;
  std::vector<std::string> programs;
  std::string emit, format = "jsonl", output;
  bool summary = false, header = false, exact = false, zero_moves = false, checked = false, call_all = false,
       json = false;
  ReproducerRequest reproducer;
  RunBudgets budgets;
  std::vector<std::string> save_table;
  std::vector<TableRequest> tables_to_save;
  CanonicalRequest canonical;

  void add_to(CommandLine& line);
  int run();
};

void RunCommand::add_to(CommandLine& line) {
  line.option("PROGRAM", programs, "Programs, each a run of its own; - is standard input").required();
  program.add_to(line);
  line.option("--emit", emit, "What to write (default: motions; with --summary alone: none)")
      .one_of({"blocks", "motions", "canonical", "none"})
      .type_name("blocks|motions|canonical|none");
  line.option("--format", format, "Form of the output")
      .one_of({"jsonl", "csv", "text"})
      .type_name("jsonl|csv|text")
      .shows_default();
  line.option("-o,--output", output, "Write to a file, which appears only when it is complete").type_name("FILE");
  line.option("--save-table", save_table,
              "Write a table as the last run left it, for a later run: MacroVariables=kept.xml (repeatable)")
      .type_name("NAME=FILE");
  line.flag("--summary", summary,
            "Blocks, events, lengths, extents, time and diagnostics by code; on standard error when standard output "
            "holds data");
  line.flag("--json", json, "Write the summary as JSON, one line for each program; motions and blocks as JSON Lines");
  line.flag("--header", header, "JSON Lines: a first line with version, dialect and units");
  line.flag("--exact", exact, "Numbers that read back to the same value instead of 6 decimals");
  line.flag("--zero-moves", zero_moves, "Keep linear moves that change no machine axis");
  canonical.add_to(line);
  budgets.add_to(line);
  line.flag("--checked", checked, "Check every access of a syntax against its declaration (slow)").group("Testing");
  line.flag("--call-all", call_all, "Call every syntax in every block; must give the same result").group("Testing");
  reproducer.add_to(line);
  common.add_to(line);
}

/// Ends the run when enough errors were reported.
class ErrorLimit : public Exporter {
 public:
  explicit ErrorLimit(const DiagnosticWriter& diagnostics) : diagnostics_(diagnostics) {}
  void begin(Document&, const SymbolTable&) override {}
  bool block(Document&, const SymbolTable&) override { return !diagnostics_.limit_reached(); }
  bool end() override { return true; }

 private:
  const DiagnosticWriter& diagnostics_;
};

/// Drops the first line: the column names of a second program in one table.
class WithoutFirstLine : public Output {
 public:
  explicit WithoutFirstLine(Output& output) : output_(output) {}
  bool write(std::string_view bytes) override {
    if (!dropped_) {
      const std::size_t end = bytes.find('\n');
      if (end == std::string_view::npos) return true;
      bytes.remove_prefix(end + 1);
      dropped_ = true;
    }
    return output_.write(bytes);
  }

 private:
  Output& output_;
  bool dropped_ = false;
};

std::unique_ptr<Exporter> make_exporter(const RunCommand& c, Output& output, const std::string& dialect,
                                        Session& session) {
  const Format format = c.format == "csv" ? Format::csv : c.format == "text" ? Format::text : Format::jsonl;
  if (c.emit == "blocks") return make_block_exporter(output, format);
  if (c.emit == "none") return nullptr;
  if (c.emit == "canonical")
    return make_canonical_exporter(output, c.canonical.text, c.canonical.options(c.exact, c.zero_moves),
                                   session.diagnostics());
  return make_motion_exporter(output, {format, c.header, c.zero_moves, c.exact, dialect});
}

/// The machine's own rates; a chain of its own answers, since tables belong to a run.
RapidRates rapid_rates(const LinkedDialect& linked, const ChainSettings& settings) {
  RapidRates rates;
  DiagnosticList ignored;
  const Chain chain(linked, settings, ignored);
  const auto* const axes = static_cast<const ig_machine_axis_1*>(chain.service("isogloss.machine-axis/1"));
  if (axes == nullptr) return rates;
  for (std::size_t i = 0; i < std::size(rates.per_second); ++i)
    if (axes->rapid_rate(axes->self, "XYZABC"[i], &rates.per_second[i]) == 0) rates.per_second[i] = 0;
  return rates;
}

/// One program after the other into one output.
class Runs {
 public:
  Runs(const RunCommand& command, Session& session, const RunOptions& options, OutputFile* output)
      : command_(command), session_(session), options_(options), output_(output) {}
  ~Runs() {
    keep_to_the_end(std::move(linked_));
    for (auto& [name, linked] : likely_) keep_to_the_end(std::move(linked));
  }
  Runs(const Runs&) = delete;
  Runs& operator=(const Runs&) = delete;

  int run(const std::string& path) {
    const std::unique_ptr<OpenedProgram> source = OpenedProgram::open(path, session_);
    if (source == nullptr) return cannot_start;
    std::string dialect = command_.program.dialect;
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
    if (guess) report_guess(path, *guess, linked_ == nullptr ? "" : parting(path, *source, *guess), session_);
    if (linked_ == nullptr) return cannot_start;
    const int status = run_linked(path, *source);
    session_.diagnostics().finish_program();
    return std::max({status, session_.status(), summary_status_});
  }

  bool output_is_gone() const { return output_is_gone_; }
  bool wrote() const { return wrote_; }

 private:
  /// How the dialect that is nearly as likely differs, for the note on what was guessed.
  std::string parting(const std::string& path, const OpenedProgram& source, const Guess& guess) {
    if (guess.next.empty()) return {};
    auto& next = likely_[guess.next];
    DiagnosticList ignored;
    if (next == nullptr) next = session_.link(guess.next, options_.chain.dependencies, ignored);
    if (next == nullptr) return {};
    RunOptions options = options_;
    add_program_places(path, linked_->dialect, options);
    const std::string place = where_moves_part(*linked_, *next, path, source.head(), options);
    return place.empty() ? ""
                         : "; " + guess.next_name + ", the next candidate, moves differently from " + place + " on";
  }

  int run_linked(const std::string& path, OpenedProgram& source) {
    RunOptions options = options_;
    add_program_places(path, linked_->dialect, options);
    std::error_code no_size;
    const std::uintmax_t size = std::filesystem::is_regular_file(path, no_size) ? std::filesystem::file_size(path) : 0;
    options.progress = [this, &path, size](std::uint64_t blocks, std::uint64_t bytes) {
      session_.progress().show(bytes, size, fmt::format("{}: {} blocks", path, blocks));
    };

    std::vector<Exporter*> exporters;
    std::unique_ptr<Exporter> data, totals, tables;
    WithoutFirstLine later(*output_);
    Summary summary;
    ErrorLimit limit(session_.diagnostics());
    try {
      const bool is_later_table = wrote_ && command_.format == "csv";
      data = make_exporter(command_, is_later_table ? static_cast<Output&>(later) : *output_, linked_->dialect.name,
                           session_);
      if (data != nullptr) exporters.push_back(data.get());
      if (command_.summary) {
        totals = make_summary_exporter(summary, rapid_rates(*linked_, options.chain));
        exporters.push_back(totals.get());
      }
      // The default ends endless loops of errors, which may wait for the next look at the budgets.
      if (command_.common.maximum_errors != 0 && command_.common.maximum_errors != CommonOptions::many_errors)
        exporters.push_back(&limit);
      options.goes_on = [&] { return command_.budgets.hold(path, session_); };
      if (!command_.tables_to_save.empty())
        exporters.push_back((tables = make_table_saver(command_.tables_to_save, session_)).get());
      const std::uint64_t errors_before = session_.diagnostics().errors();
      const RunResult result = isogloss::run(*linked_, source, path, options, exporters, session_.diagnostics());
      session_.progress().hide();
      wrote_ = true;
      output_is_gone_ = output_->reader_is_gone() || output_->is_over_allowance();
      if (output_->is_over_allowance())
        session_.report("IG-0452", {path, static_cast<std::uint32_t>(result.lines), 0},
                        {std::to_string(command_.budgets.output_bytes)});
      if (session_.diagnostics().limit_reached())
        session_.report("IG-0517", {path, static_cast<std::uint32_t>(result.lines), 0},
                        {std::to_string(session_.diagnostics().errors())});
      else
        doubt(path, session_.diagnostics().errors() - errors_before, result.blocks);
      if (command_.summary) write_summary(path, summary);
    } catch (const std::runtime_error& e) {
      if (session_.diagnostics().errors() == 0) session_.report("IG-0513", {path}, {e.what()});
      return cannot_start;  // a syntax could not be created; what its exception said may be a fault inside
    }
    return success;
  }

  /// Errors nearly everywhere have one cause most often.
  void doubt(const std::string& path, std::uint64_t errors, std::uint64_t blocks) {
    constexpr std::uint64_t least = 5;
    if (errors >= least && errors * 4 >= blocks * 3)
      session_.report("IG-0518", {path}, {std::to_string(errors), std::to_string(blocks)});
  }

  void write_summary(const std::string& path, const Summary& summary) {
    const std::string text =
        (command_.json ? summary_json : summary_text)(path, linked_->dialect.name, summary, session_.diagnostics());
    const bool beside_data = command_.emit != "none" && (command_.output.empty() || command_.output == "-");
    if (beside_data)
      summary_status_ = std::max(summary_status_, print_to_stderr(text));
    else if (command_.output.empty())
      output_->write(text);
    else
      summary_status_ = std::max(summary_status_, print(text, success));
  }

  /// Where standard error cannot be written, only the exit status can report it.
  static int print_to_stderr(const std::string& text) {
    const bool is_out = std::fwrite(text.data(), 1, text.size(), stderr) == text.size() && std::fflush(stderr) == 0;
    return is_out ? success : cannot_start;
  }

  const RunCommand& command_;
  Session& session_;
  const RunOptions& options_;
  OutputFile* output_;
  std::unique_ptr<LinkedDialect> linked_;
  std::string linked_name_;
  std::map<std::string, std::unique_ptr<LinkedDialect>> likely_;
  bool wrote_ = false, output_is_gone_ = false;
  int summary_status_ = success;
};

int RunCommand::run() {
  Session session(common);
  if (emit.empty()) emit = summary ? "none" : "motions";
  if (emit == "blocks" && format == "csv") {
    session.report("IG-0513", {}, {"blocks have no CSV form; --format jsonl or text"});
    return cannot_start;
  }
  if (json && format != "jsonl") {
    session.report("IG-0513", {}, {"--json and --format " + format + " contradict each other; leave one out"});
    return cannot_start;
  }
  const bool writes_to_stdout = output.empty() || output == "-";
  if (emit != "none" && writes_to_stdout) session.progress().data_goes_to_stdout();
  std::optional<RunOptions> options = program.make(session);
  auto tables = read_table_requests(save_table, session);
  if (!options || !tables) return cannot_start;
  if (emit == "canonical" && !canonical.prepare(format, options->chain, session)) return cannot_start;
  tables_to_save = std::move(*tables);
  std::vector<std::string> sources = programs, saved;
  sources.push_back(program.dialect);
  sources.insert(sources.end(), program.subprograms.begin(), program.subprograms.end());
  std::vector<std::string> given = {program.machine, program.offsets, program.tools, program.variables};
  if (!program.machine.empty() && !(output.empty() && common.diagnostics_output.empty()))
    for (std::string& file : files_of_machine(program.dialect)) given.push_back(std::move(file));
  for (const auto& [name, file] : tables_to_save) saved.push_back(file);
  // A table may be saved to the file it came from: the next run reads it again.
  std::vector<std::string> outputs = saved;
  outputs.push_back(output);
  outputs.push_back(common.diagnostics_output);
  if (!are_apart(sources, outputs, session) || !are_apart(given, {output, common.diagnostics_output}, session))
    return cannot_start;
  options->chain.mode = checked ? Mode::checked : Mode::fast;
  options->chain.call_all = call_all;
  watch_calls(program.watchdog);
  if (!reproducer.file.empty()) return reproducer.write(session, program, std::move(*options));
  if (std::find(programs.begin(), programs.end(), "-") == programs.end()) allow_reproducer();

  std::string error;
  const std::unique_ptr<OutputFile> file =
      output.empty() ? OutputFile::standard_output() : OutputFile::open(output, error);
  if (file == nullptr) {
    session.report("IG-0511", {output}, {error});
    return cannot_start;
  }
  file->allow(budgets.output_bytes);
  int status = success;
  Runs runs(*this, session, *options, file.get());
  for (const std::string& path : programs) {
    status = std::max(status, runs.run(path));
    if (file->is_over_allowance()) break;
    if (runs.output_is_gone()) return status;
  }
  // Nothing ran, or half a program: an older file stays as it is.
  if (!runs.wrote() || session.diagnostics().by_code().contains("IG-0431")) {
    if (output.empty() || output == "-") file->commit();  // what went to a pipe is out
    return status;
  }
  if (file->commit() || file->reader_is_gone()) return status;
  session.report("IG-0511", {output.empty() ? "standard output" : output}, {file->error()});
  return std::max<int>(status, cannot_start);
}

}  // namespace

int run_command(const Arguments& arguments) {
  auto line = std::make_unique<CommandLine>(
      "run", "Runs part programs through a dialect and writes what the machine would do.",
      "isogloss run part.nc -d fanuc --offsets offsets.xml --emit motions --format csv -o part.csv");
  RunCommand command;
  command.add_to(*line);
  if (const auto done = line->parse(arguments)) return *done;
  keep_to_the_end(std::move(line));
  return command.run();
}

}  // namespace isogloss::cli
