#include "state/restart_check.hpp"

#include <algorithm>
#include <cmath>

#include "asked_reports.hpp"
#include "isogloss/engine/motion.hpp"
#include "json_text.hpp"

namespace isogloss::cli {

namespace {

constexpr std::size_t most_compared_bytes = std::size_t{64} << 20;
constexpr double same_value = 2e-5;  // what rounding to the program's unit may leave

class MotionText : public Output {
 public:
  bool write(std::string_view bytes) override {
    text += bytes;
    return text.size() < most_compared_bytes;
  }
  std::string text;
};

/// The motions after so many blocks, from the state that they leave.
class Tail : public Exporter {
 public:
  Tail(Exporter& motions, std::uint64_t blocks_before) : motions_(motions), left_(blocks_before) {}
  void begin(Document& initial, const SymbolTable& symbols) override {
    if (left_ == 0) motions_.begin(initial, symbols);
  }
  bool block(Document& document, const SymbolTable& symbols) override {
    if (left_ == 0) return motions_.block(document, symbols);
    if (--left_ == 0) motions_.begin(document, symbols);
    return true;
  }
  bool end() override { return left_ != 0 || motions_.end(); }

 private:
  Exporter& motions_;
  std::uint64_t left_;
};

std::string motions_after(const LinkedDialect& linked, const std::string& text, const std::string& name,
                          std::uint64_t blocks_before, const RunOptions& options, DiagnosticSink& said,
                          ToolNames& tools) {
  MotionText out;
  // A move to where the tool stands shows what is in force, such as the modal call of a macro.
  const std::unique_ptr<Exporter> motions = make_motion_exporter(out, {.zero_moves = true});
  Tail tail(*motions, blocks_before);
  const std::unique_ptr<Source> source = memory_source(text);
  run(linked, *source, name, options, {&tail, &tools}, said);
  return std::move(out.text);
}

bool is_near(const Json& a, const Json& b) {
  if (a.is_number() && b.is_number()) {
    const double x = a.get<double>(), y = b.get<double>();
    return std::abs(x - y) <= same_value * std::max(1.0, std::abs(x) / 100);
  }
  if (a.type() != b.type() || a.size() != b.size()) return false;
  if (!a.is_structured()) return a == b;
  for (auto i = a.begin(), k = b.begin(); i != a.end(); ++i, ++k)
    if ((a.is_object() && i.key() != k.key()) || !is_near(*i, *k)) return false;
  return true;
}

/// Two events but for their places; lines of the main program are shifted by the preamble.
bool are_same(std::string_view a, std::string_view b) {
  const std::size_t x = a.find(R"("Event":)"), y = b.find(R"("Event":)");
  if (x == std::string_view::npos || y == std::string_view::npos) return a == b;
  if (a.substr(x) == b.substr(y)) return true;
  Json left = Json::parse(a, nullptr, false), right = Json::parse(b, nullptr, false);
  if (left.is_discarded() || right.is_discarded()) return false;
  for (const char* place : {"File", "Line"}) {
    left.erase(place);
    right.erase(place);
  }
  return is_near(left, right);
}

/// A preamble may feed along one axis down to the point, and nothing else: a cycle in it would drill.
std::uint32_t line_that_cuts(const LinkedDialect& linked, const std::string& text, const std::string& name,
                             std::uint32_t lines, const RunOptions& options) {
  std::uint32_t out = 0, last_feed = 0;
  MotionPoint at;
  const auto listener = make_motion_listener([&](const Motion& m) {
    if (m.file != name || m.line > lines) return false;
    if (m.event > Motion::Event::arc) return true;
    unsigned changed = 0;
    for (unsigned axis = 0; axis < 3; ++axis)
      changed += !at.has(axis) || std::abs(m.program.at[axis] - at.at[axis]) > same_value ? 1 : 0;
    const bool is_rapid = m.event == Motion::Event::rapid;
    if (last_feed != 0) out = last_feed;
    if (m.event == Motion::Event::arc || (!is_rapid && changed > 1)) out = m.line;
    last_feed = is_rapid ? 0 : m.line;
    at = m.program;
    return out == 0;
  });
  DiagnosticList unheard;
  const std::unique_ptr<Source> source = memory_source(text);
  run(linked, *source, name, options, {listener.get()}, unheard);
  return out;
}

std::string_view next_line(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  const std::string_view out = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return out;
}

bool begins_with_one_of(std::string_view path, std::initializer_list<std::string_view> beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(), [&](std::string_view b) { return path.starts_with(b); });
}

/// A block that the preamble repeats has the faults that it has in the program.
bool has_same(const std::vector<Diagnostic>& list, const Diagnostic& one) {
  return std::any_of(list.begin(), list.end(),
                     [&](const Diagnostic& d) { return d.code == one.code && d.message == one.message; });
}

/// What tells of the past, or only matters to the moves that are compared anyhow.
bool is_memory(std::string_view path) {
  return begins_with_one_of(
      path, {"ReferenceReturn.", "CannedCycle.", "MotionState.", "CycleDefinition.", "ProgramToMcTransform", "Source.",
             "Parsing.", "RadiusCompensation.OffsetId", "ToolHeightCompensation.OffsetId"});
}

/// What the moves behind it do not show: where the tool stands, what turns and flows.
bool is_vital(std::string_view path) {
  return begins_with_one_of(path, {"MachineCoordinate.", "SpindleSpeed.", "Coolant.", "ToolChange.", "FurtherAxes."});
}

/// A value that does nothing; a field without a value does the same.
bool is_neutral(const std::string& value) {
  for (const char* one : {"", "0", "false", R"("None")", R"("OFF")", R"("STOP")"})
    if (value == one) return true;
  return false;
}

/// Where an axis stands that no block has given a position.
bool is_assumption(std::string_view path, const ProgramPoint& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = "XYZ"[axis];
    const bool is_of_axis = path.back() == letter && path.size() >= 2 && path[path.size() - 2] == '.';
    if (!is_of_axis || point.places[axis] == AxisPlace::program) continue;
    if (path.starts_with("ProgramXyz.")) return true;
    return path.starts_with("MachineCoordinate.") && point.places[axis] == AxisPlace::unknown;
  }
  return false;
}

std::vector<StateDifference> differences(const ProgramPoint& point, const std::vector<ExplainedValue>& found) {
  std::map<std::string, std::pair<std::string, std::string>> both;
  std::map<std::string, ProgramLine> since;
  for (const ExplainedValue& v : point.block.carried) {
    both[v.path].first = v.value;
    since[v.path] = v.since.line != 0 ? v.since : v.set;
  }
  for (const ExplainedValue& v : found) both[v.path].second = v.value;
  std::vector<StateDifference> out;
  for (const auto& [path, values] : both) {
    const auto& [before, after] = values;
    // The preamble may select what the program has left to the control.
    if (is_memory(path) || is_assumption(path, point) || (before.empty() && !is_vital(path)) ||
        (is_neutral(before) && is_neutral(after)))
      continue;
    const Json a = Json::parse(before, nullptr, false), b = Json::parse(after, nullptr, false);
    if (after.empty() || before.empty() || !is_near(a, b))
      out.push_back({path, before, after, is_vital(path), since[path]});
  }
  return out;
}

}  // namespace

RestartCheck check_restart(const LinkedDialect& linked, const std::string& whole, const std::string& preamble,
                           const std::string& rest, const std::string& name, const ProgramPoint& point,
                           const RunOptions& options) {
  RestartCheck out;
  RunOptions again = options;
  again.program.clear();
  // The control keeps the rows that the program has set.
  again.chain.dependencies.insert(again.chain.dependencies.end(), point.changed_tables.begin(),
                                  point.changed_tables.end());
  const std::string text = preamble + rest;
  const auto lines = static_cast<std::uint32_t>(std::count(preamble.begin(), preamble.end(), '\n'));
  AskedReports said(is_error), said_by_whole(is_error);
  Unheard unheard;
  ExplainReach reach;
  ToolNames tools, same_tools;
  const std::string first = motions_after(linked, whole, name, point.blocks_before, options, said_by_whole, tools);
  // Names without a table are numbered as they come, and fewer come after the line.
  if (auto rows = tools.rows(linked)) again.chain.dependencies.push_back(std::move(*rows));
  const auto restarted = find_point(linked, text, name, {.line = lines + 1}, again, said, reach);
  for (Diagnostic& d : said.all)
    if (d.where.line <= lines && !has_same(said_by_whole.all, d)) out.errors.push_back(std::move(d));
  if (!restarted) return out;
  out.comes_to_rest = true;
  out.cuts_at = line_that_cuts(linked, text, name, lines, again);
  out.differences = differences(point, restarted->block.carried);

  const std::string second = motions_after(linked, text, name, restarted->blocks_before, again, unheard, same_tools);
  const bool is_cut = std::max(first.size(), second.size()) >= most_compared_bytes;
  std::string_view a = first, b = second;
  while (!a.empty() || !b.empty()) {
    const std::string_view left = next_line(a), right = next_line(b);
    if (is_cut && (a.empty() || b.empty())) break;
    if (are_same(left, right)) continue;
    const Json event = Json::parse(left.empty() ? right : left, nullptr, false);
    if (event.is_discarded()) break;  // where the comparison ends
    out.line_file = event.value("File", name);
    out.line = event.value("Line", 0u);
    if (left.empty() && out.line_file == name) out.line = out.line - lines + point.block.where.line - 1;
    break;
  }
  return out;
}

}  // namespace isogloss::cli
