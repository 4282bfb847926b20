// Where the run stands, what is in force there, and how it moves on.
#include <fmt/format.h>

#include <cmath>

#include "dap/arguments.hpp"
#include "dap/server.hpp"
#include "isogloss/engine/program_text.hpp"

namespace isogloss::dap {

namespace {

constexpr const char* not_launched = "no program is launched";
constexpr const char* running = "the program runs: pause it first";

/// A number, or a text in quotation marks, as the program writes it; empty: neither.
std::optional<std::string> program_value(const std::string& text) {
  std::size_t end = 0;
  try {
    const double value = std::stod(text, &end);
    if (text.find_first_not_of(" \t", end) == std::string::npos && std::isfinite(value))
      return block_number(value, true);
  } catch (const std::exception&) {
    end = 0;
  }
  const bool is_text = text.size() >= 2 && text.front() == '"' && text.find('"', 1) == text.size() - 1;
  for (const char c : text)
    if (static_cast<unsigned char>(c) < ' ') return std::nullopt;
  return is_text ? std::optional(text) : std::nullopt;
}

}  // namespace

DebugServer::Answer DebugServer::threads(const Json&) {
  const std::string name = is_debugged() ? "program" : "no program";
  return {{{"threads", Json::array({{{"id", 1}, {"name", name}}})}}, "", {}, false};
}

DebugServer::Answer DebugServer::stack_trace(const Json& arguments) {
  if (!is_debugged()) return {{}, not_launched, {}, false};
  Json frames = Json::array();
  const bool stands =
      debuggee_->look([&](const Standing& standing, const ProgramVariables&) { frames = StateView::frames(standing); });
  if (!stands) return {{}, running, {}, false};
  const std::size_t total = frames.size();
  const auto start =
      static_cast<std::size_t>(std::max<std::int64_t>(integer_of(arguments, "startFrame").value_or(0), 0));
  const auto levels = static_cast<std::size_t>(std::max<std::int64_t>(integer_of(arguments, "levels").value_or(0), 0));
  Json out = Json::array();
  for (std::size_t i = start; i < total && (levels == 0 || i - start < levels); ++i) {
    Json frame = frames[i];
    frame["line"] = frame["line"].get<std::int64_t>() - 1 + first_line_;
    frame["column"] = frame["column"].get<std::int64_t>() - 1 + first_column_;
    out.push_back(std::move(frame));
  }
  return {{{"stackFrames", std::move(out)}, {"totalFrames", total}}, "", {}, false};
}

DebugServer::Answer DebugServer::scopes(const Json& arguments) {
  if (!is_debugged()) return {{}, not_launched, {}, false};
  Answer out;
  const bool stands = debuggee_->look([&](const Standing& standing, const ProgramVariables&) {
    out.body["scopes"] = view_.scopes(standing, integer_of(arguments, "frameId").value_or(0), out.fault);
  });
  if (!stands) out.fault = running;
  return out;
}

DebugServer::Answer DebugServer::variables(const Json& arguments) {
  if (!is_debugged()) return {{}, not_launched, {}, false};
  Answer out;
  Json all;
  const bool stands = debuggee_->look([&](const Standing& standing, const ProgramVariables& variables) {
    all = view_.variables(standing, variables, integer_of(arguments, "variablesReference").value_or(0), out.fault);
  });
  if (!stands) return {{}, running, {}, false};
  const auto start = static_cast<std::size_t>(std::max<std::int64_t>(integer_of(arguments, "start").value_or(0), 0));
  const auto count = static_cast<std::size_t>(std::max<std::int64_t>(integer_of(arguments, "count").value_or(0), 0));
  Json some = Json::array();
  for (std::size_t i = start; i < all.size() && (count == 0 || i - start < count); ++i)
    some.push_back(std::move(all[i]));
  out.body["variables"] = std::move(some);
  return out;
}

std::string DebugServer::shown_value(const std::string& name) {
  std::string out;
  debuggee_->look([&](const Standing&, const ProgramVariables& variables) { out = shown(variables.value_of(name)); });
  return out;
}

DebugServer::Answer DebugServer::assign(const std::string& name, const std::string& value) {
  bool is_known = false;
  const bool stands = debuggee_->look(
      [&](const Standing&, const ProgramVariables& variables) { is_known = variables.find(name) != nullptr; });
  if (!stands) return {{}, running, {}, false};
  if (!is_known) return {{}, "the program has used no variable '" + name + "' so far", {}, false};
  const std::optional<std::string> text = program_value(value);
  if (!text) return {{}, "a variable takes a number, or a text in quotation marks, not '" + value + "'", {}, false};
  if (const auto fault = debuggee_->assign(name, *text)) return {{}, *fault, {}, false};
  return {{{"value", shown_value(name)}}, "", {}, false};
}

DebugServer::Answer DebugServer::set_variable(const Json& arguments) {
  if (!is_debugged()) return {{}, not_launched, {}, false};
  if (!view_.is_settable(integer_of(arguments, "variablesReference").value_or(0)))
    return {{}, "only variables of the program can be set", {}, false};
  return assign(text_of(arguments, "name"), text_of(arguments, "value"));
}

DebugServer::Answer DebugServer::set_expression(const Json& arguments) {
  if (!is_debugged()) return {{}, not_launched, {}, false};
  std::string name = text_of(arguments, "expression");
  if (name.starts_with("var(\"") && name.ends_with("\")")) name = name.substr(5, name.size() - 7);
  return assign(name, text_of(arguments, "value"));
}

DebugServer::Answer DebugServer::evaluate(const Json& arguments) {
  if (!is_debugged()) return {{}, not_launched, {}, false};
  const auto parsed = Expression::parse(text_of(arguments, "expression"), debuggee_->program().linked->layout);
  if (const auto* const fault = std::get_if<std::string>(&parsed)) return {{}, *fault, {}, false};
  Answer out;
  const bool stands = debuggee_->look([&](const Standing& standing, const ProgramVariables& variables) {
    const BlockEntry& entry = standing.entry;
    // The position is that of the last stroke that is done; the block's own moves are over where it stands before one.
    const Stroke* const last = standing.strokes.empty() ? nullptr : &standing.strokes.back();
    const Scene scene{.document = standing.document,
                      .symbols = standing.symbols,
                      .stroke = standing.position.is_within ? standing.stroke() : last,
                      .file = entry.file,
                      .program = entry.frames->back().program,
                      .line = entry.line,
                      .depth = entry.depth,
                      .pass = entry.pass,
                      .block = entry.number};
    const Value value = std::get<Expression>(parsed).evaluate(scene, variables);
    out.body = {{"result", shown(value)}, {"variablesReference", 0}};
  });
  if (!stands) out.fault = running;
  return out;
}

DebugServer::Answer DebugServer::exception_info(const Json&) {
  if (!is_debugged()) return {{}, not_launched, {}, false};
  Answer out;
  const bool stands = debuggee_->look([&](const Standing& standing, const ProgramVariables&) {
    const Stop& stop = standing.stop;
    if (stop.reason != "exception") out.fault = "the run does not stand at a diagnostic";
    const std::size_t blank = stop.description.find(' ');
    out.body = {{"exceptionId", blank == std::string::npos ? stop.description : stop.description.substr(blank + 1)},
                {"description", stop.text},
                {"breakMode", "always"}};
  });
  if (!stands) out.fault = running;
  return out;
}

DebugServer::Answer DebugServer::step(Debuggee::Step step, Json body) {
  if (!is_debugged()) return {{}, not_launched, {}, false};
  if (!debuggee_->look([](const Standing&, const ProgramVariables&) {})) return {{}, running, {}, false};
  view_.forget();
  return {std::move(body), "", [this, step] { debuggee_->step(step); }, false};
}

DebugServer::Answer DebugServer::resume(const Json&) {
  return step(Debuggee::Step::go_on, {{"allThreadsContinued", true}});
}
DebugServer::Answer DebugServer::next(const Json&) { return step(Debuggee::Step::over); }
DebugServer::Answer DebugServer::step_in(const Json&) { return step(Debuggee::Step::into); }
DebugServer::Answer DebugServer::step_out(const Json&) { return step(Debuggee::Step::out); }
DebugServer::Answer DebugServer::step_back(const Json&) { return step(Debuggee::Step::back); }
DebugServer::Answer DebugServer::reverse_continue(const Json&) { return step(Debuggee::Step::reverse); }

DebugServer::Answer DebugServer::pause(const Json&) {
  if (!is_debugged()) return {{}, not_launched, {}, false};
  debuggee_->pause();
  return {};
}

}  // namespace isogloss::dap
