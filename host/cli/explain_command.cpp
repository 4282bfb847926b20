// Explains why a block did what it did, or what a diagnostic means.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "crash_guard.hpp"
#include "dialect_guess.hpp"
#include "isogloss/engine/explain.hpp"
#include "isogloss/engine/printable.hpp"
#include "json_text.hpp"
#include "known_codes.hpp"
#include "output_file.hpp"
#include "program_options.hpp"

namespace isogloss::cli {

namespace {

struct ExplainCommand {
  CommonOptions common;
  ProgramOptions program;
  std::string what;
  ExplainTarget target;
  bool json = false;

  int run();
  int explain_code(Session& session) const;
  int explain_line(Session& session, const std::string& path);
};

std::optional<KnownCode> find_code(const std::string& code, Library& library) {
  const auto find = [&]() -> std::optional<KnownCode> {
    for (const KnownCode& known : known_codes(library))
      if (known.info.code == code) return known;
    return std::nullopt;
  };
  if (auto of_the_host = find()) return of_the_host;
  library.load_all();
  return find();
}

int ExplainCommand::explain_code(Session& session) const {
  const std::optional<KnownCode> found = find_code(what, session.library());
  if (!found) {
    session.report("IG-0516", {}, {what}, "isogloss list diagnostics names them");
    return cannot_start;
  }
  if (json)
    return print(pretty({{"Code", found->info.code},
                         {"Severity", to_string(found->info.severity)},
                         {"Plugin", found->plugin},
                         {"Text", found->info.text},
                         {"Explanation", found->info.explanation},
                         {"Example", found->info.example}}),
                 success);
  return print(
      fmt::format("{} ({}, {})\n  {}\n\n{}\n\nExample: {}\n", found->info.code, to_string(found->info.severity),
                  found->plugin, found->info.text, found->info.explanation, found->info.example),
      success);
}

/// IG-0206: capitals and digits, a hyphen, digits.
bool is_code(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  const std::string_view prefix = text.substr(0, text.find('-'));
  const std::string_view number = text.substr(std::min(prefix.size() + 1, text.size()));
  return !prefix.empty() && is_capital(prefix.front()) && !number.empty() &&
         std::all_of(prefix.begin(), prefix.end(), [&](char c) { return is_capital(c) || is_digit(c); }) &&
         std::all_of(number.begin(), number.end(), is_digit);
}

std::string origin(const ExplainedValue& v) {
  if (v.writer.empty()) return v.line == 0 ? "initial state" : fmt::format("line {}", v.line);
  return v.line == 0 ? v.writer + ", before the first block" : fmt::format("{}, line {}", v.writer, v.line);
}

std::string wrapped(const std::vector<SleepingSyntax>& list) {
  std::string out, line = " ";
  for (const SleepingSyntax& s : list) {
    if (line.size() + s.syntax.size() > 98) {
      out += line + "\n";
      line = " ";
    }
    line += " " + s.syntax;
  }
  return out + line + "\n";
}

/// The calls that led to the block, and the pass over its line; empty in the first pass of a program without calls.
std::string where_the_run_is(const ExplainedBlock& b) {
  std::string out;
  for (std::size_t i = 1; i < b.frames.size(); ++i) {
    const ExplainedFrame& f = b.frames[i];
    out += fmt::format("  called {} by {}:{}", f.program, b.frames[i - 1].file, f.call_line);
    out += f.passes > 1 ? fmt::format(", pass {} of {}\n", f.pass, f.passes) : "\n";
  }
  if (b.frames.size() > 1 || b.pass > 1) out += fmt::format("  pass {} over this line (--pass N: another)\n", b.pass);
  return out;
}

/// The dependencies that answer the syntax: tables of the dialect, or of the machine.
std::string asked(const ExplainedStep& step) {
  std::string out;
  for (const ExplainedAnswer& a : step.answers)
    if (out.find(" " + a.dependency) == std::string::npos) out += (out.empty() ? ", asks " : ", ") + a.dependency;
  return out;
}

std::string place_of(const ExplainedRow& r) {
  return r.where.file.empty() ? "given by --set, or by the table itself"
                              : fmt::format("{}:{}", r.where.file, r.where.line);
}

std::string text_of(const ExplainedBlock& b) {
  std::string out = fmt::format("{}:{}: {}\n", b.where.file, b.where.line, printable(b.text, "\t"));
  out += where_the_run_is(b);
  if (!b.calls.empty()) out += fmt::format("  calls {}, {}:{}\n", b.calls, b.callee.file, b.callee.line);
  std::size_t width = 0;
  for (const ExplainedValue& v : b.carried) width = std::max(width, v.path.size() + v.value.size() + 3);
  if (!b.carried.empty()) out += "\nCarried into the block:\n";
  for (const ExplainedValue& v : b.carried)
    out += fmt::format("  {:<{}}  {}\n", v.path + " = " + v.value, std::min<std::size_t>(width, 60), origin(v));
  for (const ExplainedStep& step : b.steps) {
    out += fmt::format("\n{}{}{}\n", step.syntax, step.plugin.empty() ? "" : " (" + step.plugin + ")", asked(step));
    for (const ExplainedRow& r : step.rows)
      out += fmt::format("  row {} of {}, {}\n", r.row, r.dependency, place_of(r));
    if (step.changes.empty()) out += "  was called, changed nothing\n";
    for (const ExplainedChange& c : step.changes) {
      if (c.before.empty())
        out += fmt::format("  + {} = {}\n", c.path, c.after);
      else if (c.after.empty())
        out += fmt::format("  - {} = {}\n", c.path, c.before);
      else
        out += fmt::format("  ~ {} = {} (was {})\n", c.path, c.after, c.before);
    }
  }
  if (!b.slept.empty()) out += "\nSlept, since nothing that wakes them was set:\n" + wrapped(b.slept);
  return out + "\nAfter the block:\n" + b.document + "\n";
}

Json json_of(const std::vector<ExplainedValue>& values) {
  Json out = Json::array();
  for (const ExplainedValue& v : values) {
    Json one{{"Path", v.path}, {"Value", Json::parse(v.value)}};
    if (!v.writer.empty()) one["Writer"] = v.writer;
    if (v.line != 0) one["Line"] = v.line;
    out.push_back(std::move(one));
  }
  return out;
}

Json json_of(const ExplainedBlock& b) {
  Json steps = Json::array();
  for (const ExplainedStep& s : b.steps) {
    Json changes = Json::array();
    for (const ExplainedChange& c : s.changes) {
      Json one{{"Path", c.path}};
      if (!c.before.empty()) one["Before"] = Json::parse(c.before);
      if (!c.after.empty()) one["After"] = Json::parse(c.after);
      changes.push_back(std::move(one));
    }
    Json step{{"Syntax", s.syntax}};
    if (!s.plugin.empty()) step["Plugin"] = s.plugin;
    for (const ExplainedAnswer& a : s.answers)
      step["Asks"].push_back({{"Service", a.service}, {"Dependency", a.dependency}});
    for (const ExplainedRow& r : s.rows) {
      Json one{{"Dependency", r.dependency}, {"Row", r.row}};
      if (!r.where.file.empty()) one.update({{"File", r.where.file}, {"Line", r.where.line}});
      step["Rows"].push_back(std::move(one));
    }
    step["Changes"] = std::move(changes);
    steps.push_back(std::move(step));
  }
  Json slept = Json::array();
  for (const SleepingSyntax& s : b.slept) slept.push_back({{"Syntax", s.syntax}, {"WakesOn", s.wakes_on}});
  Json frames = Json::array();
  for (const ExplainedFrame& f : b.frames) {
    Json one{{"File", f.file}};
    if (!f.program.empty()) one.update({{"Program", f.program}, {"CallLine", f.call_line}});
    if (f.passes > 1) one.update({{"Pass", f.pass}, {"Passes", f.passes}});
    frames.push_back(std::move(one));
  }
  Json calls = Json::object();
  if (!b.calls.empty()) calls = {{"Program", b.calls}, {"File", b.callee.file}, {"Line", b.callee.line}};
  return {{"File", b.where.file},
          {"Line", b.where.line},
          {"Calls", std::move(calls)},
          {"Pass", b.pass},
          {"Frames", std::move(frames)},
          {"Text", b.text},
          {"Carried", json_of(b.carried)},
          {"Steps", std::move(steps)},
          {"Slept", std::move(slept)},
          {"Values", json_of(b.values)},
          {"Document", Json::parse(b.document)}};
}

/// The content of a line, for a file that can be read again. Lines end as in the run: LF, CR or both.
struct LineInFile {
  std::uint32_t lines = 0;  ///< up to this line; fewer than asked for: the file has no more
  bool is_empty = true;
};

LineInFile look_up(const std::string& path, std::uint32_t number) {
  std::error_code code;
  std::ifstream file;
  if (std::filesystem::is_regular_file(path, code)) file.open(path, std::ios::binary);
  LineInFile out;
  bool is_begun = false;
  char before = '\0', buffer[65536];
  while (file.read(buffer, sizeof buffer), file.gcount() > 0)
    for (const char c : std::string_view(buffer, static_cast<std::size_t>(file.gcount()))) {
      const bool is_half_end = before == '\r' && c == '\n';
      before = c;
      if (is_half_end) continue;
      if (!is_begun && out.lines == number) return out;
      if (!is_begun) ++out.lines;
      is_begun = c != '\n' && c != '\r';
      if (out.lines == number && is_begun && c != ' ' && c != '\t') out.is_empty = false;
    }
  return out;
}

/// Why the run has no block there.
std::string why_not(const ExplainReach& reach, const ExplainTarget& target, const std::string& path) {
  if (reach.passes > 0 && reach.passes < target.pass)
    return fmt::format("the run comes to this line {} times", reach.passes);
  if (const LineInFile line = look_up(target.file.empty() ? path : std::string(), target.line); line.lines > 0) {
    if (line.lines < target.line) return fmt::format("the file has {} lines", line.lines);
    if (line.is_empty) return "the line is empty";
  }
  if (reach.first == 0) return "no block of this file is executed";
  if (target.line < reach.first) return fmt::format("the run begins at line {}", reach.first);
  if (reach.jumped_to != 0)
    return fmt::format("the run goes from line {} to line {}", reach.jumped_from, reach.jumped_to);
  return fmt::format("the run ends at {}:{}: {}", reach.last.file, reach.last.line, reach.last_text);
}

int ExplainCommand::explain_line(Session& session, const std::string& path) {
  std::optional<RunOptions> options = program.make(session);
  const std::unique_ptr<OpenedProgram> source = OpenedProgram::open(path, session);
  if (!options || source == nullptr) return cannot_start;
  std::optional<std::string> dialect = program.dialect;
  if (dialect->empty()) dialect = guessed(path, source->head(), session);
  const std::unique_ptr<LinkedDialect> linked = dialect ? session.link(*dialect, options->chain.dependencies) : nullptr;
  if (linked == nullptr) return cannot_start;
  add_program_places(path, linked->dialect, *options);
  watch_calls(program.watchdog);

  // Diagnostics of other lines were not asked for.
  DiagnosticList said;
  ExplainReach reach;
  const std::vector<ExplainedBlock> blocks = explain(*linked, *source, path, target, *options, said, &reach);
  for (Diagnostic& d : said.all) {
    const bool ends_the_run = blocks.empty() && d.severity == Severity::error && d.where.line == reach.last.line &&
                              d.where.file == reach.last.file;
    if (d.where.line == target.line || d.where.line == 0 || ends_the_run) session.diagnostics().add(std::move(d));
  }
  if (blocks.empty()) {
    session.report("IG-0515", {target.file.empty() ? path : target.file, target.line, 0}, {std::to_string(target.line)},
                   why_not(reach, target, path));
    return input_errors;
  }
  std::string out;
  Json all = Json::array();
  for (const ExplainedBlock& b : blocks) {
    if (json)
      all.push_back(json_of(b));
    else
      out += (out.empty() ? "" : "\n") + text_of(b);
  }
  return print(json ? pretty(all) : out, session.status());
}

int ExplainCommand::run() {
  Session session(common);
  if (is_code(what)) return explain_code(session);
  const std::size_t colon = what.rfind(':');
  const std::string number = colon == std::string::npos ? "" : what.substr(colon + 1);
  const bool is_line = !number.empty() && number.size() < 10 &&
                       std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!is_line || std::stoul(number) == 0) {
    session.report("IG-0513", {}, {"explain needs PROGRAM:LINE or the code of a diagnostic, not '" + what + "'"});
    return cannot_start;
  }
  target.line = static_cast<std::uint32_t>(std::stoul(number));
  return explain_line(session, what.substr(0, colon));
}

}  // namespace

int explain_command(const Arguments& arguments) {
  CommandLine line(
      "explain",
      "Explains a line: what each syntax made of it, what was carried into it and which syntax wrote that; "
      "or explains a diagnostic.",
      "isogloss explain part.nc:42 -d fanuc\n  isogloss explain IG-0206");
  ExplainCommand command;
  line.option("PROGRAM:LINE", command.what, "A line of a program, or the code of a diagnostic").required();
  line.option("--in", command.target.file, "The file of a called program that holds LINE (default: PROGRAM)")
      .type_name("FILE");
  line.option("--pass", command.target.pass, "Which pass, for a line that runs several times")
      .at_least(1)
      .type_name("N")
      .shows_default();
  line.flag("--json", command.json, "Write JSON");
  command.program.add_to(line);
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
