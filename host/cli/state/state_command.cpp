// Shows what is in force at a line of a program, or writes the blocks that restore it for a restart there.
#include <fmt/format.h>

#include <algorithm>

#include "crash_guard.hpp"
#include "dialect_guess.hpp"
#include "isogloss/engine/chain.hpp"
#include "isogloss/engine/printable.hpp"
#include "json_text.hpp"
#include "output_file.hpp"
#include "program_options.hpp"
#include "run_progress.hpp"
#include "state/preamble.hpp"
#include "state/restart_check.hpp"

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
  bool json = false, after = false, as_preamble = false, with_rest = false;

  int run();
  int show(Session& session, const std::string& path);
  int write_preamble(Session& session, const LinkedDialect& linked, const std::string& text, const std::string& path,
                     const ProgramPoint& point, const RunOptions& options) const;
  std::vector<StateRow> rows(const ProgramPoint& point, const Layout& layout) const;
  std::string text_of(const ProgramPoint& point, const std::vector<StateRow>& state) const;
  Json json_of(const ProgramPoint& point, const std::vector<StateRow>& state, const std::string& dialect) const;
};

std::vector<StateRow> StateCommand::rows(const ProgramPoint& point, const Layout& layout) const {
  std::vector<StateRow> out;
  for (const ExplainedValue& v : after ? point.block.values : point.block.carried) {
    const auto field = layout.find(v.path);
    if (!field || !is_carried(layout.fields[*field].life)) continue;
    out.push_back({v, layout.fields[*field].unit, layout.fields[*field].doc});
  }
  return out;
}

std::string StateCommand::text_of(const ProgramPoint& point, const std::vector<StateRow>& state) const {
  const ExplainedBlock& b = point.block;
  std::string out = fmt::format("{}:{}: {}\nIn force {} the block:\n", b.where.file, b.where.line,
                                printable(b.text, "\t"), after ? "after" : "before");
  std::vector<std::string> shown;
  std::size_t names = 0, values = 0;
  for (const StateRow& row : state) {
    std::string value = row.value.value;
    if (value.size() > 1 && value.front() == '"') value = value.substr(1, value.size() - 2);
    if (!row.unit.empty()) value += " " + row.unit;
    names = std::max(names, row.value.path.size());
    values = std::max(values, std::min<std::size_t>(value.size(), 24));
    shown.push_back(std::move(value));
  }
  for (std::size_t i = 0; i < state.size(); ++i) {
    const auto& [file, line] = state[i].value.set;
    const std::string place = line == 0              ? "at start"
                              : file == b.where.file ? fmt::format("line {}", line)
                                                     : fmt::format("{}:{}", file, line);
    out += fmt::format("  {:<{}}  {:<{}}  {:<10}  {}\n", state[i].value.path, names, shown[i], values, place,
                       state[i].title);
  }
  if (!after && !point.variables.empty()) out += "Variables that the program has set:\n";
  if (!after)
    for (const auto& [number, value] : point.variables)
      out += fmt::format("  {:>6}  {}\n", number, value ? fmt::format("{}", *value) : "empty");
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
  for (const auto& [number, value] : point.variables)
    variables.push_back({{"Variable", number}, {"Value", value ? Json(*value) : Json()}});
  out["Variables"] = std::move(variables);
  return out;
}

/// Why no blocks can restore the state there; empty: they may.
std::string why_not(const ProgramPoint& point) {
  const ExplainedBlock& b = point.block;
  if (b.frames.size() > 1)
    return fmt::format("its block is in the called program {}, which line {} calls", b.frames.back().program,
                       b.frames[1].call_line);
  if (b.pass > 1) return "the line is in a loop, whose passes a preamble cannot count";
  for (const ExplainedValue& v : b.carried)
    if (v.path == "RadiusCompensation.Side" && v.value != R"("None")")
      return fmt::format("cutter radius compensation has been active since line {}, so restart before that line",
                         v.set.line);
  return {};
}

/// The text from this line on. Lines end as in a run: LF, CR or both.
std::string from_line(const std::string& text, std::uint32_t line) {
  std::size_t at = 0;
  for (std::uint32_t number = 1; number < line && at < text.size(); ++number) {
    at = std::min(text.find_first_of("\r\n", at), text.size());
    if (at < text.size()) at += text.compare(at, 2, "\r\n") == 0 ? 2 : 1;
  }
  return text.substr(at);
}

int StateCommand::write_preamble(Session& session, const LinkedDialect& linked, const std::string& text,
                                 const std::string& path, const ProgramPoint& point, const RunOptions& options) const {
  const Location where = point.block.where;
  const std::string line = std::to_string(where.line);
  DiagnosticList unheard;  // what the run has said already
  ProgramText words;
  {
    Chain chain(linked, options.chain, unheard);
    words = ProgramText::of(chain);
  }
  if (!has_preamble(words)) {
    session.report("IG-0194", {}, {linked.dialect.name, "the blocks of a restart"});
    return input_errors;
  }
  if (const std::string reason = why_not(point); !reason.empty()) {
    session.report("IG-0195", where, {line, reason});
    return input_errors;
  }
  const std::string preamble = make_preamble(words, point, linked.layout);
  const std::string rest = from_line(text, where.line);
  const RestartCheck check = check_restart(linked, text, preamble, rest, path, point, options);
  session.progress().hide();
  for (const DependencyElement& table : point.changed_tables) session.report("IG-0198", where, {table.alias, line});
  for (const Diagnostic& d : check.errors) session.report("IG-0195", where, {line, d.message});
  if (!check.comes_to_rest && check.errors.empty())
    session.report("IG-0195", where, {line, "the blocks of the preamble end the program"});
  for (const StateDifference& d : check.differences)
    session.report(d.is_vital || check.line != 0 ? "IG-0196" : "IG-0199", where,
                   {d.path, d.found.empty() ? "nothing" : d.found, d.wanted.empty() ? "nothing" : d.wanted});
  if (check.line != 0) session.report("IG-0197", {check.line_file, check.line, 0}, {line});
  if (session.status() != success) return session.status();
  return print(with_rest ? preamble + rest : preamble, success);
}

int StateCommand::show(Session& session, const std::string& path) {
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

  DiagnosticList said;
  ExplainReach reach;
  const std::optional<ProgramPoint> point = find_point(*linked, *text, path, target, *options, said, reach);
  if (!point) {
    for (Diagnostic& d : said.all)
      if (d.severity == Severity::error) session.diagnostics().add(std::move(d));
    const std::string end = reach.last.line == 0
                                ? std::string("no block of the program is executed")
                                : fmt::format("the run ends at {}:{}", reach.last.file, reach.last.line);
    session.report("IG-0515", {target.file.empty() ? path : target.file, target.line, 0}, {std::to_string(target.line)},
                   end);
    return input_errors;
  }
  if (as_preamble) return write_preamble(session, *linked, *text, path, *point, *options);
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
  line.flag("--json", command.json, "Write JSON");
  command.program.add_to(line);
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
