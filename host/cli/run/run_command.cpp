// The main job: programs in, motions or blocks out.
#include <unistd.h>

#include <algorithm>

#include "crash_guard.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "run/runs.hpp"

namespace isogloss::cli {

namespace {

struct RunCommand : RunArguments {
  void add_to(CommandLine& line);
  int run(const CommandLine& line);
  void report_idle_options(const CommandLine& line, Session& session) const;
  UntrustedWork untrusted_work() const;
};

void RunCommand::add_to(CommandLine& line) {
  line.option("PROGRAM", programs, "Programs, each a run of its own; - is standard input").required();
  program.add_to(line);
  line.option("--emit", emit, "What to write (default: motions; with --summary alone: none)")
      .one_of({"blocks", "motions", "canonical", "none"})
      .type_name("blocks|motions|canonical|none");
  line.option("--format", format, "Form of the output")
      .one_of({"jsonl", "csv", "text", "binary"})
      .type_name("jsonl|csv|text|binary")
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
  line.option("--scan-ahead", scan_ahead,
              "Scan a program of more lines on a second processor, ahead of the run (0: never); the result is the same")
      .type_name("LINES")
      .shows_default();
  line.flag("--checked", checked, "Check every access of a syntax against its declaration (slow)").group("Testing");
  line.flag("--call-all", call_all, "Call every syntax in every block; must give the same result").group("Testing");
  reproducer.add_to(line);
  untrusted.add_to(line);
  common.add_to(line);
}

UntrustedWork RunCommand::untrusted_work() const {
  UntrustedWork out = cli::untrusted_work(common, program);
  out.programs = programs;
  out.outputs.push_back(output);
  for (const std::string& request : save_table)
    if (const std::size_t equals = request.find('='); equals != std::string::npos)
      out.outputs.push_back(request.substr(equals + 1));
  out.memory_mib = budgets.memory_mib;
  out.output_bytes = budgets.output_bytes;
  return out;
}

/// Options for which the chosen output has no use.
void RunCommand::report_idle_options(const CommandLine& line, Session& session) const {
  const bool has_moves = emit == "motions" || emit == "canonical", is_empty = emit == "none";
  const auto tell = [&](const char* option, bool has_use, const char* why) {
    if (!has_use && line.is_given(option))
      session.report("IG-0519", {}, {option, is_empty ? "nothing is written" : why});
  };
  tell("--format", !is_empty, "");
  tell("--output", !is_empty, "");
  tell("--json", emit == "motions" || emit == "blocks" || summary, "the canonical program is no JSON");
  tell("--header", emit == "motions" && format == "jsonl", "only motions as JSON Lines begin with one");
  tell("--exact", has_moves && format != "binary", "these numbers are always exact");
  tell("--zero-moves", has_moves, "blocks are written whether they move or not");
  tell("--max-output", !is_empty || summary, "");
  tell("--frame", emit == "canonical", "only the canonical program has one");
  tell("--tolerance", emit == "canonical", "only the canonical program has one");
}

int RunCommand::run(const CommandLine& line) {
  Session session(common);
  if (emit.empty()) emit = summary ? "none" : "motions";
  report_idle_options(line, session);
  if (emit == "none") output.clear();  // an empty file would take the place of an older one
  if (emit == "blocks" && (format == "csv" || format == "binary")) {
    const std::string form = format == "csv" ? "CSV" : "binary";
    session.report("IG-0513", {}, {"blocks have no " + form + " form; --format jsonl or text"});
    return cannot_start;
  }
  if (json && format != "jsonl") {
    session.report("IG-0513", {}, {"--json and --format " + format + " contradict each other; leave one out"});
    return cannot_start;
  }
  const bool writes_to_stdout = output.empty() || output == "-";
  if (format == "binary" && emit == "motions" && writes_to_stdout && is_terminal(STDOUT_FILENO)) {
    session.report("IG-0513", {}, {"--format binary is not for a terminal; give -o FILE, or a pipe"});
    return cannot_start;
  }
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
  options->scans_ahead_after = scan_ahead;
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
  const CommandLine& parsed = *line;
  keep_to_the_end(std::move(line));
  if (const auto done = enter_untrusted(command.untrusted, command.untrusted_work())) return *done;
  return command.run(parsed);
}

}  // namespace isogloss::cli
