#include "state/restart.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "asked_reports.hpp"
#include "explain/frame_text.hpp"
#include "isogloss/engine/chain.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss::cli {

namespace {

/// Lines before the one that was asked for, from near to far. Each costs six runs.
constexpr std::size_t most_lines_tried = 60;
constexpr const char* what_to_do =
    "restart at an earlier line, such as a tool change; --nearest finds the nearest one that can be restored";

const ExplainedValue* active_compensation(const ProgramPoint& point) {
  for (const ExplainedValue& v : point.block.carried)
    if (v.path == "RadiusCompensation.Side" && v.value != R"("None")") return &v;
  return nullptr;
}

/// "X Y": the axes that no block has given a position.
std::string resting_axes(const ProgramPoint& point) {
  std::string out;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (point.places[axis] == AxisPlace::unknown) out += (out.empty() ? "" : " ") + std::string(1, "XYZ"[axis]);
  return out;
}

/// Why no blocks can restore the state there; empty: they may.
std::string why_not(const ProgramPoint& point) {
  const ExplainedBlock& b = point.block;
  if (b.frames.size() > 1)
    return fmt::format("its block is in the called program {}, which line {} calls", b.frames.back().program,
                       b.frames[1].call_line);
  if (b.pass > 1) return "the line is in a loop, whose passes a preamble cannot count";
  if (const ExplainedValue* const v = active_compensation(point))
    return fmt::format("cutter radius compensation has been active since line {}, so restart before that line",
                       v->since.line != 0 ? v->since.line : v->set.line);
  return {};
}

}  // namespace

Restart::Restart(Session& session, const LinkedDialect& linked, const std::string& text, const std::string& path,
                 const ProgramLines& lines, const RunOptions& options)
    : session_(session), linked_(linked), text_(text), path_(path), lines_(lines), options_(options) {
  Unheard unheard;  // what the run has said already
  Chain chain(linked, options.chain, unheard);
  words_ = ProgramText::of(chain);
}

bool Restart::Trial::is_good() const {
  return std::none_of(faults.begin(), faults.end(), [](const auto& d) { return d.severity == Severity::error; });
}

Restart::Trial Restart::attempt(const ProgramPoint& point) const {
  Trial out;
  const Location where = point.block.where;
  const std::string line = std::to_string(where.line);
  if (const std::string reason = why_not(point); !reason.empty()) {
    out.faults.push_back(host_diagnostic("IG-0195", where, {line, reason}));
    out.faults.back().hint = what_to_do;
    return out;
  }
  out.preamble = make_preamble(words_, point, lines_, linked_.layout);
  const RestartCheck check =
      check_restart(linked_, text_, out.preamble, from_line(text_, where.line), path_, point, options_);
  add_outcome(check, point, out);
  return out;
}

/// " (line 3: G51 X0 Y0)"; empty where no line is known.
std::string Restart::set_by(const ProgramLine& line) const {
  if (line.line == 0) return {};
  const std::string text = printable(lines_.block(line), "\t");
  const std::string place =
      line.file == path_ ? fmt::format("line {}", line.line) : fmt::format("line {} of {}", line.line, line.file);
  return fmt::format(" ({}{})", place, text.empty() ? "" : ": " + text.substr(0, text.find('\n')));
}

/// What makes the rest move differently: the first value that is not restored, or what no value shows.
std::string Restart::cause_of_difference(const std::vector<StateDifference>& differences) const {
  for (const StateDifference& d : differences)
    if (d.since.line != 0) return fmt::format("{} is not restored{}", d.path, set_by(d.since));
  for (const StateDifference& d : differences) return d.path + " is not restored";
  return "it depends on what ran before that line: a loop, a counter, a jump or a call back to an earlier line";
}

void Restart::add_outcome(const RestartCheck& check, const ProgramPoint& point, Trial& out) const {
  const Location where = point.block.where;
  const std::string line = std::to_string(where.line);
  const auto report = [&](std::string_view code, const Location& at, std::initializer_list<std::string> arguments) {
    Diagnostic d = host_diagnostic(code, at, arguments);
    if (d.severity == Severity::error) d.hint = what_to_do;
    out.faults.push_back(std::move(d));
  };
  for (const DependencyElement& table : point.changed_tables) report("IG-0198", where, {table.alias, line});
  if (const std::string axes = resting_axes(point); !axes.empty()) report("IG-0622", where, {axes, line});
  for (const Diagnostic& d : check.errors) {
    const std::string block = from_line(out.preamble, d.where.line);
    report("IG-0195", where, {line, fmt::format("its block {}: {}", block.substr(0, block.find('\n')), d.message)});
  }
  if (!check.comes_to_rest && check.errors.empty())
    report("IG-0195", where, {line, "the blocks of the preamble end the program"});
  const RestartValues values(point, lines_, linked_.layout);
  std::vector<StateDifference> lost;
  for (const StateDifference& d : check.differences)
    if (d.is_vital || !is_past(d.path, values.state())) lost.push_back(d);
  if (check.line != 0) report("IG-0197", {check.line_file, check.line, 0}, {line, cause_of_difference(lost)});
  for (const StateDifference& d : lost)
    report(d.is_vital || check.line != 0 ? "IG-0196" : "IG-0199", where,
           {d.path, d.found.empty() ? "nothing" : short_value(d.found),
            (d.wanted.empty() ? "nothing" : short_value(d.wanted)) + set_by(d.since)});
  if (check.cuts_at != 0) report("IG-0621", where, {line, std::to_string(check.cuts_at)});
}

bool Restart::is_past(std::string_view path, const StateFields& state) const {
  for (const ProgramText::Row& row : words_.rows) {
    std::string beginning;
    const auto no_values = [](std::string_view, std::string_view, std::string&) { return false; };
    if (row.name.starts_with("past ") && holds(row.when, state) && row.block.fill(no_values, beginning) &&
        path.starts_with(beginning))
      return true;
  }
  return false;
}

std::optional<std::string> Restart::write(const ProgramPoint& point, bool takes_nearest) {
  if (!has_preamble(words_)) {
    session_.report("IG-0194", {}, {linked_.dialect.name, "the blocks of a restart"});
    return std::nullopt;
  }
  line_ = point.block.where.line;
  Trial trial = attempt(point);
  if (!trial.is_good() && takes_nearest)
    if (auto found = write_nearest(point)) return found;
  for (Diagnostic& d : trial.faults) session_.diagnostics().add(std::move(d));
  return trial.is_good() ? std::optional(std::move(trial.preamble)) : std::nullopt;
}

std::optional<std::string> Restart::write_nearest(const ProgramPoint& point) {
  std::uint32_t below = point.block.frames.size() > 1 ? point.block.frames[1].call_line + 1 : point.block.where.line;
  if (const ExplainedValue* const v = active_compensation(point); v != nullptr && v->set.file == path_)
    below = std::min(below, (v->since.line != 0 ? v->since.line : v->set.line) + 1);
  std::size_t tried = 0;
  for (auto at = point.lines_before.rbegin(); at != point.lines_before.rend() && tried < most_lines_tried; ++at) {
    if (*at >= below) continue;
    ++tried;
    Unheard unheard;
    ExplainReach reach;
    const auto before = find_point(linked_, text_, path_, {.line = *at}, options_, unheard, reach);
    if (!before) continue;
    Trial trial = attempt(*before);
    if (!trial.is_good()) continue;
    session_.report("IG-0620", before->block.where,
                    {std::to_string(point.block.where.line), std::to_string(before->block.where.line)});
    for (Diagnostic& d : trial.faults) session_.diagnostics().add(std::move(d));
    line_ = before->block.where.line;
    return std::move(trial.preamble);
  }
  return std::nullopt;
}

}  // namespace isogloss::cli
