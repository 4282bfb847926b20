// Breakpoints as the client asks for them, and the table that the run looks at.
#include <fmt/format.h>

#include "dap/arguments.hpp"
#include "dap/server.hpp"

namespace isogloss::dap {

namespace {

constexpr const char* waits_for_launch = "the program is not launched yet";

/// Condition, hit count and message of one breakpoint; a sentence when one of them is wrong.
std::optional<std::string> read_parts(const Json& wanted, const Layout& layout, Breakpoint& out) {
  if (const std::string text = text_of(wanted, "condition"); !text.empty()) {
    auto parsed = Expression::parse(text, layout);
    if (auto* const fault = std::get_if<std::string>(&parsed)) return *fault;
    out.condition = std::get<Expression>(std::move(parsed));
  }
  if (const std::string text = text_of(wanted, "hitCondition"); !text.empty()) {
    const auto parsed = HitCondition::parse(text);
    if (const auto* const fault = std::get_if<std::string>(&parsed)) return *fault;
    out.hits = std::get<HitCondition>(parsed);
  }
  if (const std::string text = text_of(wanted, "logMessage"); !text.empty()) {
    auto parsed = LogMessage::parse(text, layout);
    if (auto* const fault = std::get_if<std::string>(&parsed)) return *fault;
    out.log = std::get<LogMessage>(std::move(parsed));
  }
  return std::nullopt;
}

}  // namespace

/// The answer for the breakpoints of one file, which enter the table where they can be hit.
Json DebugServer::verified(const std::string& path, const Json& wanted, BreakpointTable& table) {
  const std::string file = canonical_path(path);
  Json out = Json::array();
  for (const Json& one : wanted) {
    const std::int64_t asked = integer_of(one, "line").value_or(0) - first_line_ + 1;
    Breakpoint breakpoint;
    breakpoint.id = id_of(fmt::format("{}:{}", file, asked));
    Json answer{{"id", breakpoint.id}, {"verified", false}, {"line", asked - 1 + first_line_}};
    const bool is_line = asked >= 1 && asked < UINT32_MAX;
    std::optional<std::uint32_t> line;
    if (!is_debugged())
      answer["message"] = waits_for_launch;
    else if (is_line)
      line = debuggee_->statements().statement_at(path, static_cast<std::uint32_t>(asked));
    const auto fault = line ? read_parts(one, debuggee_->program().linked->layout, breakpoint) : std::nullopt;
    if (fault) {
      answer["message"] = *fault;
    } else if (line) {
      answer["verified"] = true;
      answer["line"] = *line - 1 + first_line_;
      table.lines[file][*line].push_back(std::move(breakpoint));
    } else if (is_debugged()) {
      answer["message"] = fmt::format("no block begins on line {}: it is empty or holds a comment alone", asked);
    }
    out.push_back(std::move(answer));
  }
  return out;
}

Json DebugServer::verified_logic(const Json& wanted, BreakpointTable& table) {
  Json out = Json::array();
  for (const Json& one : wanted) {
    const int id = id_of(text_of(one, "name"));
    Json answer{{"id", id}, {"verified", false}};
    if (!is_debugged()) {
      answer["message"] = waits_for_launch;
      out.push_back(std::move(answer));
      continue;
    }
    const Layout& layout = debuggee_->program().linked->layout;
    auto parsed = Expression::parse(text_of(one, "name"), layout);
    Breakpoint parts;
    std::optional<std::string> fault;
    if (auto* const sentence = std::get_if<std::string>(&parsed)) fault = *sentence;
    if (!fault) fault = read_parts(one, layout, parts);
    if (fault) {
      answer["message"] = *fault;
    } else {
      answer["verified"] = true;
      table.logic.push_back(
          {id, std::get<Expression>(std::move(parsed)), std::move(parts.condition), std::move(parts.hits)});
    }
    out.push_back(std::move(answer));
  }
  return out;
}

int DebugServer::id_of(const std::string& breakpoint) {
  return ids_.try_emplace(breakpoint, static_cast<int>(ids_.size()) + 1).first->second;
}

/// All requests anew, and the answers by path; "" is for the conditions.
std::map<std::string, Json> DebugServer::make_table() {
  auto table = std::make_shared<BreakpointTable>();
  std::map<std::string, Json> answers;
  for (const auto& [path, wanted] : line_requests_) answers[path] = verified(path, wanted, *table);
  answers[""] = verified_logic(logic_request_, *table);
  table->stops_at_errors = filters_.contains("error");
  table->stops_at_warnings = filters_.contains("warning");
  if (!is_debugged()) return answers;
  if (launched_.no_debug) *table = {};
  debuggee_->set_breakpoints(std::move(table));
  return answers;
}

DebugServer::Answer DebugServer::set_breakpoints(const Json& arguments) {
  const auto source = arguments.find("source");
  const std::string path = source == arguments.end() ? std::string() : text_of(*source, "path");
  if (path.empty()) return {{}, "setBreakpoints needs the path of a source", {}, false};
  Json wanted = list_of(arguments, "breakpoints");
  if (wanted.empty())
    for (const Json& line : list_of(arguments, "lines")) wanted.push_back({{"line", line}});
  line_requests_[path] = wanted;
  return {{{"breakpoints", make_table()[path]}}, "", {}, false};
}

DebugServer::Answer DebugServer::set_logic_breakpoints(const Json& arguments) {
  logic_request_ = list_of(arguments, "breakpoints");
  return {{{"breakpoints", make_table()[""]}}, "", {}, false};
}

DebugServer::Answer DebugServer::set_exception_breakpoints(const Json& arguments) {
  const std::vector<std::string> wanted = texts_of(arguments, "filters");
  filters_ = {wanted.begin(), wanted.end()};
  make_table();
  Json out = Json::array();
  for (const std::string& filter : wanted) {
    const bool is_known = filter == "error" || filter == "warning";
    Json one{{"verified", is_known}};
    if (!is_known) one["message"] = "there are the filters error and warning, not " + filter;
    out.push_back(std::move(one));
  }
  return {{{"breakpoints", std::move(out)}}, "", {}, false};
}

DebugServer::Answer DebugServer::breakpoint_locations(const Json& arguments) {
  if (!is_debugged()) return {{}, "no program is launched", {}, false};
  const auto source = arguments.find("source");
  const std::string path = source == arguments.end() ? std::string() : text_of(*source, "path");
  if (path.empty()) return {{}, "breakpointLocations needs the path of a source", {}, false};
  const std::int64_t first = integer_of(arguments, "line").value_or(first_line_) - first_line_ + 1;
  const std::int64_t last = integer_of(arguments, "endLine").value_or(first - 1 + first_line_) - first_line_ + 1;
  Json out = Json::array();
  if (first >= 1 && last >= first && last < UINT32_MAX)
    for (const std::uint32_t line :
         debuggee_->statements().between(path, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last)))
      out.push_back({{"line", line - 1 + first_line_}});
  return {{{"breakpoints", std::move(out)}}, "", {}, false};
}

}  // namespace isogloss::dap
