// Explains why a block did what it did, follows a field, or says what a diagnostic means.
#include <algorithm>

#include "asked_reports.hpp"
#include "chain_trial.hpp"
#include "crash_guard.hpp"
#include "dialect_guess.hpp"
#include "explain/block_json.hpp"
#include "explain/explain_code.hpp"
#include "explain/explain_target.hpp"
#include "explain/follow_field.hpp"
#include "json_text.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "program_options.hpp"
#include "run_progress.hpp"
#include "sandbox/untrusted.hpp"

namespace isogloss::cli {

namespace {

struct ExplainCommand {
  CommonOptions common;
  ProgramOptions program;
  std::string what, field;
  ExplainTarget target;
  bool json = false, brief = false, all = false;

  int run();
  int explain_lines(Session& session, const NamedLines& lines);
  int explain_blocks(Session& session, const std::string& path, const LinkedDialect& linked, Source& source,
                     RunOptions options) const;
};

/// Diagnostics of other lines were not asked for; what ended the run before these lines was.
void report_said(const AskedReports& said, const ExplainReach& reach, bool found_blocks, Session& session) {
  for (const Diagnostic& d : said.all) session.diagnostics().add(d);
  if (found_blocks) return;
  for (const Diagnostic& d : said.last_errors) {
    const bool is_at_the_end = d.where.line == reach.last.line && d.where.file == reach.last.file;
    if (is_at_the_end || reach.last.line == 0) session.diagnostics().add(d);
  }
}

int ExplainCommand::explain_blocks(Session& session, const std::string& path, const LinkedDialect& linked,
                                   Source& source, RunOptions options) const {
  AskedReports said([&](const Diagnostic& d) {
    return d.where.line == 0 || (d.where.line >= target.line && d.where.line <= target.last());
  });
  said.end_at_errors(options, common.maximum_errors);
  ExplainReach reach;
  std::vector<ExplainedBlock> blocks;
  try {
    blocks = explain(linked, source, path, target, options, said, &reach);
  } catch (const std::runtime_error& e) {
    return report_no_begin(linked, options.chain, path, e, session);
  }
  session.progress().hide();
  report_said(said, reach, !blocks.empty(), session);
  if (said.has_ended_run()) session.report("IG-0517", reach.last, {std::to_string(said.errors())});
  if (blocks.empty()) {
    const std::string asked = target.last() == target.line
                                  ? std::to_string(target.line)
                                  : std::to_string(target.line) + "-" + std::to_string(target.last());
    session.report("IG-0515", {target.file.empty() ? path : target.file, target.line, 0}, {asked},
                   why_no_block(reach, target, path));
    return input_errors;
  }
  if (reach.is_cut) session.report("IG-0182", {path, target.line, 0}, {std::to_string(blocks.size())});
  LineTexts lines;
  const Amount amount = brief ? Amount::sentence : all ? Amount::all : Amount::changes;
  std::string out;
  Json list = Json::array();
  for (const ExplainedBlock& b : blocks) {
    if (json)
      list.push_back(json_of(b, amount, lines, said.all));
    else
      out += (out.empty() || brief ? "" : "\n") + text_of(b, amount, lines, said.all);
  }
  return print(json ? pretty(list) : out, session.status());
}

int ExplainCommand::explain_lines(Session& session, const NamedLines& lines) {
  const std::string& path = lines.program;
  std::vector<std::string> inputs = program.files();
  inputs.insert(inputs.end(), {path, target.file});
  if (!are_apart(inputs, {common.diagnostics_output}, session)) return cannot_start;
  std::optional<RunOptions> options = program.make(session);
  const std::unique_ptr<OpenedProgram> source = OpenedProgram::open(path, session);
  if (!options || source == nullptr) return cannot_start;
  std::optional<std::string> dialect = program.dialect;
  if (dialect->empty()) dialect = guessed(path, source->head(), session);
  const std::unique_ptr<LinkedDialect> linked = dialect ? session.link(*dialect, options->chain.dependencies) : nullptr;
  if (linked == nullptr) return cannot_start;
  report_short_file(lines, target.file.empty() ? path : target.file, session);
  add_program_places(path, linked->dialect, *options);
  watch_calls(program.watchdog);
  show_progress(*options, path, session);
  if (!field.empty()) return follow_field({field, target.file, lines, json}, *linked, *source, *options, session);
  return explain_blocks(session, path, *linked, *source, *options);
}

int ExplainCommand::run() {
  Session session(common);
  if (is_code(what)) return explain_code(what, json, session);
  if (brief && all) {
    session.report("IG-0513", {}, {"--brief leaves out what --all shows"});
    return cannot_start;
  }
  const auto lines = read_lines(what, field.empty() ? Lines::needed : Lines::optional, session);
  if (!lines) return cannot_start;
  target.line = lines->first;
  target.last_line = lines->last;
  return explain_lines(session, *lines);
}

}  // namespace

int explain_command(const Arguments& arguments) {
  CommandLine line("explain",
                   "Explains a line: what it does and why, who uses each of its words, the way of its point from the "
                   "program to the machine, and what it changes. Follows one field through a program. Explains a "
                   "diagnostic.",
                   "isogloss explain part.nc:42 -d fanuc\n"
                   "  isogloss explain part.nc:10-20 --brief\n"
                   "  isogloss explain part.nc --field Feedrate\n"
                   "  isogloss explain IG-0206");
  ExplainCommand command;
  line.option("PROGRAM:LINE", command.what,
              "A line of a program, a range such as part.nc:10-20, or the code of a diagnostic")
      .required();
  line.option("--in", command.target.file, "The file of a called program that holds LINE (default: PROGRAM)")
      .type_name("FILE");
  line.option("--pass", command.target.pass, "Which pass, for a line that runs several times")
      .at_least(1)
      .type_name("N")
      .shows_default()
      .not_with("--field");
  line.flag("--brief", command.brief, "One sentence for each block, and nothing else").not_with("--field");
  line.flag("--all", command.all,
            "Also the values that were carried into the block and those after it, each call, and the syntaxes that "
            "slept")
      .not_with("--field");
  line.option("--field", command.field,
              "Follow a field or section through PROGRAM: each change with its line, its value and who set it")
      .type_name("FIELD");
  line.flag("--json", command.json,
            "Write JSON, as schemas/explain.schema.json, or explain-field.schema.json, describes it");
  command.program.add_to(line);
  UntrustedOptions untrusted;
  untrusted.add_to(line);
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  const std::vector<std::string> of_programs = line.given_besides("Common", {"--json", "--untrusted", "--max-time"});
  if (is_code(command.what) && !of_programs.empty()) {
    Session(command.common)
        .report("IG-0513", {},
                {of_programs.front() + " has no effect: " + command.what +
                 " is the code of a diagnostic, which is explained without a program"});
    return cannot_start;
  }
  UntrustedWork work = untrusted_work(command.common, command.program);
  work.programs.push_back(program_of_lines(command.what));
  work.reads.push_back(command.target.file);
  if (const auto done = enter_untrusted(untrusted, work)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
