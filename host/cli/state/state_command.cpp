// Shows what is in force at a line of a program, or writes the blocks that restore it for a restart there.
#include <fmt/format.h>

#include <algorithm>

#include "asked_reports.hpp"
#include "chain_trial.hpp"
#include "crash_guard.hpp"
#include "dialect_guess.hpp"
#include "explain/frame_text.hpp"
#include "isogloss/engine/printable.hpp"
#include "json_text.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "program_options.hpp"
#include "run_progress.hpp"
#include "sandbox/untrusted.hpp"
#include "state/restart.hpp"

namespace isogloss::cli {

namespace {

/// A field that is carried from block to block.
struct StateRow {
  ExplainedValue value;
  std::string unit, title;
};

struct StateCommand {
  CommonOptions common;
  ProgramOptions program;
  std::string what;
  ExplainTarget target;
  bool json = false, after = false, as_preamble = false, with_rest = false, nearest = false;

  int run();
  int show(Session& session, const std::string& path);
  std::vector<StateRow> rows(const ProgramPoint& point, const Layout& layout) const;
  std::string text_of(const ProgramPoint& point, const std::vector<StateRow>& state) const;
  Json json_of(const ProgramPoint& point, const std::vector<StateRow>& state, const std::string& dialect) const;
};

/// Another field tells it.
std::string unit_of_feed(const std::vector<ExplainedValue>& values) {
  for (const ExplainedValue& v : values)
    if (v.path == "Feedrate.Unit" && v.value.size() > 2) return v.value.substr(1, v.value.size() - 2);
  return {};
}

std::vector<StateRow> StateCommand::rows(const ProgramPoint& point, const Layout& layout) const {
  std::vector<StateRow> out;
  const std::vector<ExplainedValue>& values = after ? point.block.values : point.block.carried;
  for (const ExplainedValue& v : values) {
    const auto field = layout.find(v.path);
    if (!field || !is_carried(layout.fields[*field].life)) continue;
    std::string unit = layout.fields[*field].unit;
    if (v.path == "Feedrate.FeedrateValue") unit = unit_of_feed(values);
    out.push_back({v, std::move(unit), layout.fields[*field].doc});
  }
  return out;
}

/// Without quotes, and of numbers what a machine can tell apart.
std::string shown_value(const std::string& json) {
  if (json.size() > 1 && json.front() == '"') return json.substr(1, json.size() - 2);
  return short_value(json);
}

std::string place_of(const ProgramLine& at, std::string_view file) {
  if (at.line == 0) return "at start";
  return at.file == file ? fmt::format("line {}", at.line) : fmt::format("{}:{}", at.file, at.line);
}

std::string StateCommand::text_of(const ProgramPoint& point, const std::vector<StateRow>& state) const {
  const ExplainedBlock& b = point.block;
  std::string out = fmt::format("{}:{}: {}\nIn force {} the block:\n", b.where.file, b.where.line,
                                printable(b.text, "\t"), after ? "after" : "before");
  std::vector<std::string> shown;
  std::size_t names = 0, values = 0;
  for (const StateRow& row : state) {
    std::string value = shown_value(row.value.value);
    if (!row.unit.empty()) value += " " + row.unit;
    names = std::max(names, row.value.path.size());
    values = std::max(values, std::min<std::size_t>(value.size(), 24));
    shown.push_back(std::move(value));
  }
  for (std::size_t i = 0; i < state.size(); ++i) {
    out += fmt::format("  {:<{}}  {:<{}}  {:<10}  {}\n", state[i].value.path, names, shown[i], values,
                       place_of(state[i].value.set, b.where.file), state[i].title);
  }
  if (!after && !point.variables.empty()) out += "Variables that the program has set:\n";
  if (!after)
    for (const VariableAt& v : point.variables)
      out += fmt::format("  {:>8}  {:<{}}  {}\n", v.name, v.value.empty() ? "empty" : shown_value(v.value), values,
                         place_of(v.last, b.where.file));
  return out;
}

Json StateCommand::json_of(const ProgramPoint& point, const std::vector<StateRow>& state,
                           const std::string& dialect) const {
  Json rows = Json::array();
  for (const StateRow& row : state) {
    Json one{{"Path", row.value.path}, {"Value", Json::parse(row.value.value)}, {"Title", row.title}};
    if (!row.unit.empty()) one["Unit"] = row.unit;
    if (!row.value.writer.empty()) one["Writer"] = row.value.writer;
    if (row.value.set.line != 0) one["File"] = row.value.set.file, one["Line"] = row.value.set.line;
    rows.push_back(std::move(one));
  }
  Json out{{"File", point.block.where.file},
           {"Line", point.block.where.line},
           {"Pass", point.block.pass},
           {"Text", point.block.text},
           {"Dialect", dialect},
           {"When", after ? "after" : "before"},
           {"State", std::move(rows)}};
  if (after) return out;
  Json variables = Json::array();
  for (const VariableAt& v : point.variables)
    variables.push_back({{"Variable", v.name},
                         {"Value", v.value.empty() ? Json() : Json::parse(v.value)},
                         {"File", v.last.file},
                         {"Line", v.last.line}});
  out["Variables"] = std::move(variables);
  return out;
}

int StateCommand::show(Session& session, const std::string& path) {
  std::vector<std::string> inputs = program.files();
  inputs.insert(inputs.end(), {path, target.file});
  if (!are_apart(inputs, {common.diagnostics_output}, session)) return cannot_start;
  std::optional<RunOptions> options = program.make(session);
  if (!options) return cannot_start;
  std::string error;
  const std::optional<std::string> text = read_text(path, error);
  if (!text) {
    session.report("IG-0510", {path}, {error});
    return cannot_start;
  }
  std::optional<std::string> dialect = program.dialect;
  if (dialect->empty()) dialect = guessed(path, std::string_view(*text).substr(0, guessed_head_bytes), session);
  const std::unique_ptr<LinkedDialect> linked = dialect ? session.link(*dialect, options->chain.dependencies) : nullptr;
  if (linked == nullptr) return cannot_start;
  add_program_places(path, linked->dialect, *options);
  watch_calls(program.watchdog);
  show_progress(*options, path, session);

  AskedReports said(is_error);
  RunOptions limited = *options;
  said.end_at_errors(limited, common.maximum_errors);
  ExplainReach reach;
  ProgramLines lines(path, *text);
  std::optional<ProgramPoint> point;
  try {
    point = find_point(*linked, *text, path, target, limited, said, reach, &lines);
  } catch (const std::runtime_error& e) {
    return report_no_begin(*linked, options->chain, path, e, session);
  }
  if (!point || said.has_ended_run()) {
    for (Diagnostic& d : said.all) session.diagnostics().add(std::move(d));
    if (said.has_ended_run()) session.report("IG-0517", reach.last, {std::to_string(said.errors())});
    const std::string end = reach.last.line == 0
                                ? std::string("no block of the program is executed")
                                : fmt::format("the run ends at {}:{}", reach.last.file, reach.last.line);
    session.report("IG-0515", {target.file.empty() ? path : target.file, target.line, 0}, {std::to_string(target.line)},
                   end);
    return input_errors;
  }
  if (as_preamble) {
    Restart restart(session, *linked, *text, path, lines, *options);
    const std::optional<std::string> preamble = restart.write(*point, nearest);
    session.progress().hide();
    if (!preamble) return session.status();
    return print(with_rest ? *preamble + from_line(*text, restart.line()) : *preamble, session.status());
  }
  session.progress().hide();
  const std::vector<StateRow> state = rows(*point, linked->layout);
  return print(json ? pretty(json_of(*point, state, linked->dialect.name)) : text_of(*point, state), session.status());
}

int StateCommand::run() {
  Session session(common);
  const std::size_t colon = what.rfind(':');
  const std::string number = colon == std::string::npos ? "" : what.substr(colon + 1);
  const bool is_line = !number.empty() && number.size() < 10 &&
                       std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  std::string fault;
  if (!is_line || std::stoul(number) == 0) fault = "state needs PROGRAM:LINE, not '" + what + "'";
  if (with_rest && !as_preamble) fault = "--with-rest writes the rest behind a preamble: give --as-preamble, too";
  if (nearest && !as_preamble) fault = "--nearest chooses the line of a preamble: give --as-preamble, too";
  if (as_preamble && (after || json))
    fault = "--as-preamble writes blocks that restore the state before the line: leave --after and --json out";
  if (as_preamble && !target.file.empty()) fault = "--as-preamble restarts the main program: leave --in out";
  if (!fault.empty()) {
    session.report("IG-0513", {}, {fault});
    return cannot_start;
  }
  target.line = static_cast<std::uint32_t>(std::stoul(number));
  return show(session, what.substr(0, colon));
}

}  // namespace

int state_command(const Arguments& arguments) {
  CommandLine line(
      "state",
      "Shows what is in force at a line of a program: each value with its unit and the line that set it; "
      "or writes the blocks that restore it, for a restart in mid-program.",
      "isogloss state part.nc:142 -d fanuc\n  isogloss state part.nc:142 --as-preamble --with-rest > rest.nc");
  StateCommand command;
  line.option("PROGRAM:LINE", command.what, "A line of a program").required();
  line.flag("--after", command.after, "The state after the line instead of the one before it");
  line.option("--in", command.target.file, "The file of a called program that holds LINE (default: PROGRAM)")
      .type_name("FILE");
  line.option("--pass", command.target.pass, "Which pass, for a line that runs several times")
      .at_least(1)
      .type_name("N")
      .shows_default();
  line.flag("--as-preamble", command.as_preamble,
            "Write blocks that restore the state, after checking that the rest then moves as in the whole program; "
            "exit status 1, and nothing written, where no blocks can");
  line.flag("--with-rest", command.with_rest, "Write the program from LINE on behind the preamble");
  line.flag("--nearest", command.nearest,
            "Where no blocks restore the state before LINE, restart at the nearest line before it where they do");
  line.flag("--json", command.json, "Write JSON");
  command.program.add_to(line);
  UntrustedOptions untrusted;
  untrusted.add_to(line);
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  UntrustedWork work = untrusted_work(command.common, command.program);
  work.programs.push_back(program_of_lines(command.what));
  work.reads.push_back(command.target.file);
  if (const auto done = enter_untrusted(untrusted, work)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
