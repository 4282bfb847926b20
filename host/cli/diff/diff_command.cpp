// Where two dialects, two machines, two settings or two programs part, and why.
#include <fmt/format.h>

#include <optional>

#include "crash_guard.hpp"
#include "dialect_guess.hpp"
#include "diff/compare.hpp"
#include "diff/diff_request.hpp"
#include "diff/report.hpp"
#include "diff/trials.hpp"
#include "json_text.hpp"
#include "outputs.hpp"

namespace isogloss::cli {

namespace {

using namespace parting;

struct DiffCommand : DiffRequest {
  int run();

 private:
  struct Work {
    std::array<std::unique_ptr<LinkedDialect>, 2> linked;
    std::array<RunOptions, 2> options;
  };
  std::optional<RunOfSide> prepare(std::size_t side, const KeptProgram& text, Work& work, Session& session);
  int compare(const std::string& path, Session& session);
  int compare_pair(const RunOfSide& a, const RunOfSide& b, const LineOrder* order, Session& session);
  void name_sides(RunOfSide& a, RunOfSide& b) const;
  int trouble(const RunOfSide& side, const std::string& fault, std::vector<Diagnostic>& reported,
              Session& session) const;
  void report_cuts(const RunOfSide& a, const RunOfSide& b, const std::array<bool, 2>& is_cut, Session& session) const;

  Tolerance tolerance_;
  std::optional<std::string> guess_;  // of the dialect, from the program of side A: it holds for both
  std::string text_;
  std::vector<Json> comparisons_;
};

std::optional<RunOfSide> DiffCommand::prepare(std::size_t side, const KeptProgram& text, Work& work, Session& session) {
  ProgramOptions options = program;
  if (!options.take_side(dialects[side], machines[side], session)) return std::nullopt;
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
    for (std::size_t side = 0; side < 2; ++side)
      if (const std::optional<Diagnostic>& error = report.first_error[side])
        session.report(
            "IG-0184", error->where,
            {(side == 0 ? a : b).side.name, std::to_string(report.errors[side]), error->message, error->code});
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
  for (const std::string& file : program.files()) inputs.push_back(file);
  for (std::size_t side = 0; side < 2; ++side) inputs.insert(inputs.end(), {dialects[side], machines[side]});
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
  if (const auto done = enter_untrusted(command.untrusted, command.untrusted_work())) return *done;
  return command.run();
}

}  // namespace isogloss::cli
