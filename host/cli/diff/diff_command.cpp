// Where two dialects, two machines, two settings or two programs part, and why.
#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "crash_guard.hpp"
#include "dialect_guess.hpp"
#include "diff/compare.hpp"
#include "diff/report.hpp"
#include "diff/trials.hpp"
#include "json_text.hpp"
#include "outputs.hpp"
#include "program_options.hpp"

namespace isogloss::cli {

namespace {

using namespace parting;

struct DiffCommand {
  CommonOptions common;
  ProgramOptions program;
  std::vector<std::string> programs;
  std::array<std::string, 2> dialects, machines;
  std::array<std::vector<std::string>, 2> sets;
  std::string against, tolerance_text, page;
  std::vector<std::string> ignored;
  bool motions = false, all = false, json = false;

  void add_to(CommandLine& line);
  int run();

 private:
  struct Work {
    std::array<std::unique_ptr<LinkedDialect>, 2> linked;
    std::array<RunOptions, 2> options;
  };
  bool has_sides() const;
  bool read_operands(Session& session);
  std::optional<Tolerance> read_tolerance(Session& session) const;
  std::optional<RunOfSide> prepare(std::size_t side, const KeptProgram& text, Work& work, Session& session);
  int compare(const std::string& path, Session& session);
  int compare_pair(const RunOfSide& a, const RunOfSide& b, const LineOrder* order, Session& session);
  void name_sides(RunOfSide& a, RunOfSide& b) const;
  int trouble(const RunOfSide& side, const std::string& fault, std::vector<Diagnostic>& reported,
              Session& session) const;
  void report_cuts(const RunOfSide& a, const RunOfSide& b, const std::array<bool, 2>& is_cut, Session& session) const;

  Tolerance tolerance_;
  std::string second_;                // the program of side b; empty: that of side a
  std::optional<std::string> guess_;  // of the dialect, from the program of side A: it holds for both
  std::string text_;
  std::vector<Json> comparisons_;
};

void DiffCommand::add_to(CommandLine& line) {
  line.option("PROGRAM", programs,
              "Programs, each compared with itself in A and B; or two programs, where no option names two sides")
      .required();
  static constexpr const char* names[2][6] = {
      {"-a", "--machine-a", "--set-a", "Dialect of side A, by name or file (default: -d)",
       "Machine of side A (default: -m)", "As --set, on side A alone (repeatable)"},
      {"-b", "--machine-b", "--set-b", "Dialect of side B, by name or file (default: -d)",
       "Machine of side B (default: -m)", "As --set, on side B alone (repeatable)"}};
  for (std::size_t side = 0; side < 2; ++side) {
    line.option(names[side][0], dialects[side], names[side][3]).type_name("DIALECT").group("Two sides");
    line.option(names[side][1], machines[side], names[side][4]).type_name("MACHINE").group("Two sides");
    line.option(names[side][2], sets[side], names[side][5]).type_name("NAME=VALUE").group("Two sides");
  }
  line.option("--against", against, "The program of side B, where PROGRAM is that of side A alone")
      .type_name("FILE")
      .group("Two sides");
  line.flag("--motions", motions, "Compare the resolved motions alone: how far they are apart, not why");
  line.option("--tolerance", tolerance_text,
              "With --motions: what counts as the same, in mm and in degrees, each from 0 to 1000, e.g. 0.01 or "
              "0.01,0.05 (default: 0.000001)")
      .type_name("MM[,DEG]");
  line.option("--ignore", ignored, "Do not compare this field or section, e.g. Comment or Source.N (repeatable)")
      .type_name("FIELD");
  line.flag("--all", all, "List every block that differs, after the causes");
  line.flag("--json", json, "Write JSON");
  line.option("--html", page, "Write a page that shows all of it, too").type_name("FILE");
  program.add_to(line);
  common.add_to(line);
}

bool DiffCommand::has_sides() const {
  for (std::size_t side = 0; side < 2; ++side)
    if (!dialects[side].empty() || !machines[side].empty() || !sets[side].empty()) return true;
  return false;
}

/// Which programs stand on which side.
bool DiffCommand::read_operands(Session& session) {
  second_ = against;
  if (second_.empty() && !has_sides() && programs.size() == 2) {
    second_ = programs.back();
    programs.pop_back();
  }
  if (!against.empty() && programs.size() > 1) {
    session.report("IG-0513", {}, {"--against compares one PROGRAM with one other, not several"});
    return false;
  }
  if (second_.empty() && !has_sides()) {
    session.report("IG-0185", {}, {}, "isogloss diff -a fanuc -b syntec part.nc");
    return false;
  }
  if (second_ == "-" && programs.front() == "-") {
    session.report("IG-0513", {}, {"standard input is one program: the other needs a file"});
    return false;
  }
  return true;
}

/// "0.01" or "0.01,0.05".
std::optional<Tolerance> DiffCommand::read_tolerance(Session& session) const {
  Tolerance out;
  if (tolerance_text.empty()) return out;
  const std::string_view text = tolerance_text;
  const std::size_t comma = text.find(',');
  const auto read = [](std::string_view part, double& value) {
    constexpr double greatest = 1000;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    return !part.empty() && error == std::errc() && end == part.data() + part.size() && value >= 0 && value <= greatest;
  };
  bool is_sound = motions && read(text.substr(0, comma), out.mm);
  out.degrees = out.mm;
  if (comma != std::string_view::npos) is_sound = is_sound && read(text.substr(comma + 1), out.degrees);
  if (is_sound) return out;
  session.report("IG-0186", {}, {tolerance_text}, motions ? "" : "it belongs to --motions");
  return std::nullopt;
}

std::optional<RunOfSide> DiffCommand::prepare(std::size_t side, const KeptProgram& text, Work& work, Session& session) {
  ProgramOptions options = program;
  if (!dialects[side].empty()) {
    options.dialect = dialects[side];
    options.machine.clear();
  }
  if (!machines[side].empty()) {
    options.machine = machines[side];
    options.dialect = dialects[side];
  }
  options.set.insert(options.set.end(), sets[side].begin(), sets[side].end());
  std::optional<RunOptions> made = options.make(session);
  if (!made) return std::nullopt;
  if (options.dialect.empty() && !guess_) guess_ = guessed(text.path(), text.head(session), session);
  if (options.dialect.empty() && !guess_) return std::nullopt;
  if (options.dialect.empty()) options.dialect = *guess_;
  work.linked[side] = session.link(options.dialect, made->chain.dependencies);
  if (work.linked[side] == nullptr) return std::nullopt;
  add_program_places(text.path(), work.linked[side]->dialect, *made);
  RunOfSide out;
  out.side = {work.linked[side]->dialect.name, work.linked[side].get(), made->chain.dependencies,
              made->chain.assignments};
  out.program = &text;
  out.options = std::move(*made);
  out.watchdog = program.watchdog;
  out.most_errors = common.maximum_errors;
  return out;
}

/// By what tells them apart.
void DiffCommand::name_sides(RunOfSide& a, RunOfSide& b) const {
  if (a.side.name != b.side.name) return;
  if (a.program != b.program) {
    a.side.name = a.program->path();
    b.side.name = b.program->path();
    return;
  }
  const auto name = [](RunOfSide& side, const char* letter, const std::vector<std::string>& set) {
    side.side.name = fmt::format("{} {}", letter, side.side.name);
    for (const std::string& one : set) side.side.name += " " + one;
  };
  name(a, "A", sets[0]);
  name(b, "B", sets[1]);
}

int DiffCommand::trouble(const RunOfSide& side, const std::string& fault, std::vector<Diagnostic>& reported,
                         Session& session) const {
  for (Diagnostic& d : reported) session.diagnostics().add(std::move(d));
  session.report("IG-0188", {side.program->path()}, {side.side.name, fault});
  return cannot_start;
}

/// What follows the errors was not compared.
void DiffCommand::report_cuts(const RunOfSide& a, const RunOfSide& b, const std::array<bool, 2>& is_cut,
                              Session& session) const {
  for (std::size_t side = 0; side < 2; ++side)
    if (is_cut[side])
      session.report("IG-0517", {(side == 0 ? a : b).program->path()}, {std::to_string(common.maximum_errors)});
}

int DiffCommand::compare_pair(const RunOfSide& a, const RunOfSide& b, const LineOrder* order, Session& session) {
  if (motions) {
    MotionReport report = compare_motions(a, b, order, tolerance_, all, session);
    for (std::size_t side = 0; side < 2; ++side)
      if (!report.faults[side].empty())
        return trouble(side == 0 ? a : b, report.faults[side], report.reported_by_fault[side], session);
    report_cuts(a, b, report.is_cut, session);
    text_ += (text_.empty() ? "" : "\n") + as_text(report);
    if (json || !page.empty()) comparisons_.push_back(as_json(report));
    return report.parted == 0 ? success : input_errors;
  }
  BlockResult result = compare_blocks(a, b, order, ignored, {order != nullptr, all, {}}, session);
  for (std::size_t side = 0; side < 2; ++side) {
    if (!result.faults[side].empty())
      return trouble(side == 0 ? a : b, result.faults[side], result.reported_by_fault[side], session);
  }
  report_cuts(a, b, result.is_cut, session);
  try_causes(result.report, a, b, order, ignored, session);
  for (const std::string& field : result.unknown_fields) session.report("IG-0189", {}, {field});
  if (result.errors_of_both > 0)
    session.report("IG-0187", {a.program->path()}, {std::to_string(result.errors_of_both)}, "isogloss run lists them");
  text_ += (text_.empty() ? "" : "\n") + as_text(result.report);
  if (json || !page.empty()) comparisons_.push_back(as_json(result.report));
  return result.report.parted == 0 ? success : input_errors;
}

int DiffCommand::compare(const std::string& path, Session& session) {
  const std::unique_ptr<KeptProgram> first = KeptProgram::open(path, session);
  if (first == nullptr) return cannot_start;
  const std::unique_ptr<KeptProgram> second = second_.empty() ? nullptr : KeptProgram::open(second_, session);
  if (second == nullptr && !second_.empty()) return cannot_start;
  Work work;
  guess_.reset();
  std::optional<RunOfSide> a = prepare(0, *first, work, session);
  if (!a) return cannot_start;
  std::optional<RunOfSide> b = prepare(1, second != nullptr ? *second : *first, work, session);
  if (!b) return cannot_start;
  name_sides(*a, *b);
  std::optional<LineOrder> order;
  if (second != nullptr) {
    const std::unique_ptr<Source> one = first->source(session), other = second->source(session);
    if (one == nullptr || other == nullptr) return cannot_start;
    const std::vector<LineText> lines = read_lines(*one);
    order.emplace(lines, read_lines(*other));
  }
  return compare_pair(*a, *b, order ? &*order : nullptr, session);
}

int DiffCommand::run() {
  Session session(common);
  if (!read_operands(session)) return cannot_start;
  const std::optional<Tolerance> tolerance = read_tolerance(session);
  if (!tolerance) return cannot_start;
  tolerance_ = *tolerance;
  std::vector<std::string> inputs = programs;
  inputs.push_back(second_);
  if (!are_apart(inputs, {page, common.diagnostics_output}, session)) return cannot_start;
  watch_calls(0);  // the comparison itself notices a run that does not go on
  int status = success;
  for (const std::string& path : programs) {
    status = std::max(status, compare(path, session));
    session.diagnostics().finish_program();
  }
  if (!page.empty() && !comparisons_.empty() && !write_file(page, as_page(comparisons_), session))
    status = std::max<int>(status, cannot_start);
  if (!json) return print(text_, status);
  if (comparisons_.empty()) return status;
  return print(pretty({{"IsoglossDiff", 1}, {"Comparisons", comparisons_}}), status);
}

}  // namespace

int diff_command(const Arguments& arguments) {
  CommandLine line(
      "diff",
      "Shows where two dialects, two machines, two settings or two programs part, grouped by the syntax, "
      "option or row of a table that is the cause. Exit status: 0 no difference, 1 differences, 2 trouble.",
      "isogloss diff -a fanuc -b syntec part.nc\n"
      "  isogloss diff -d fanuc --set-b FanucParameterTable.5115=500 part.nc\n"
      "  isogloss diff -d fanuc old.nc new.nc --motions --tolerance 0.01");
  DiffCommand command;
  command.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
