// Messages, events, and the life of a session.
#include "dap/server.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "dap/arguments.hpp"

namespace isogloss::dap {

namespace {

constexpr int only_thread = 1;
constexpr std::uint64_t most_of_one_code = 100;

Json shown_source(const std::string& file) {
  return {{"name", std::filesystem::path(file).filename().string()}, {"path", canonical_path(file)}};
}

}  // namespace

DebugServer::DebugServer(FrameReader reader, FrameWriter::Write write, Prepare prepare)
    : reader_(std::move(reader)), writer_(std::move(write)), prepare_(std::move(prepare)) {}

DebugServer::~DebugServer() = default;

bool DebugServer::serve() {
  bool is_sound = true;
  while (!is_over_) {
    editors::Frame frame = reader_.next();
    if (const auto* const end = std::get_if<editors::EndOfInput>(&frame)) {
      is_sound = !end->inside_message;
      break;
    }
    if (const auto* const bad = std::get_if<editors::BadFrame>(&frame)) {
      send_event("output", {{"category", "stderr"}, {"output", "isogloss dap: " + bad->why + "\n"}});
      if (!bad->is_fatal) continue;
      is_sound = false;
      break;
    }
    answer(std::get<Json>(frame));
  }
  debuggee_.reset();
  return is_sound;
}

void DebugServer::send_event(const std::string& event, Json body) {
  writer_.send({{"seq", ++sequence_}, {"type", "event"}, {"event", event}, {"body", std::move(body)}});
}

void DebugServer::answer(const Json& request) {
  const std::string type = text_of(request, "type");
  if (type == "response") return;
  Json response{{"seq", ++sequence_}, {"type", "response"}};
  const std::optional<std::int64_t> number = integer_of(request, "seq");
  const std::string command = text_of(request, "command");
  response["request_seq"] = number.value_or(0);
  response["command"] = command;
  Answer answer;
  if (type != "request" || command.empty())
    answer.fault = "a message needs \"type\": \"request\" and a command";
  else
    answer = handle(command, request.contains("arguments") ? request["arguments"] : Json::object());
  response["success"] = answer.fault.empty();
  if (!answer.fault.empty()) {
    response["message"] = answer.fault;
    response["body"] = {{"error",
                         {{"id", answer.is_unknown ? 2 : 1},
                          {"format", "{_reason}"},
                          {"showUser", true},
                          {"variables", {{"_reason", answer.fault}}}}}};
  } else if (!answer.body.is_null()) {
    response["body"] = std::move(answer.body);
  }
  writer_.send(response);
  if (answer.after) answer.after();
}

DebugServer::Answer DebugServer::handle(const std::string& command, const Json& arguments) {
  const auto handler = handlers().find(command);
  if (handler == handlers().end()) return {{}, "isogloss dap does not know the request '" + command + "'", {}, true};
  if (!arguments.is_object()) return {{}, "the arguments of " + command + " must be an object", {}, false};
  try {
    return (this->*handler->second)(arguments);
  } catch (const std::exception& fault) {
    return {{}, command + " failed: " + fault.what(), {}, false};
  }
}

const std::map<std::string, DebugServer::Handler, std::less<>>& DebugServer::handlers() {
  static const std::map<std::string, Handler, std::less<>> all{
      {"initialize", &DebugServer::initialize},
      {"launch", &DebugServer::launch},
      {"attach", &DebugServer::attach},
      {"configurationDone", &DebugServer::configuration_done},
      {"restart", &DebugServer::restart},
      {"terminate", &DebugServer::terminate},
      {"disconnect", &DebugServer::disconnect},
      {"setBreakpoints", &DebugServer::set_breakpoints},
      {"setFunctionBreakpoints", &DebugServer::set_logic_breakpoints},
      {"setExceptionBreakpoints", &DebugServer::set_exception_breakpoints},
      {"breakpointLocations", &DebugServer::breakpoint_locations},
      {"threads", &DebugServer::threads},
      {"stackTrace", &DebugServer::stack_trace},
      {"scopes", &DebugServer::scopes},
      {"variables", &DebugServer::variables},
      {"setVariable", &DebugServer::set_variable},
      {"setExpression", &DebugServer::set_expression},
      {"evaluate", &DebugServer::evaluate},
      {"exceptionInfo", &DebugServer::exception_info},
      {"loadedSources", &DebugServer::loaded_sources},
      {"source", &DebugServer::source},
      {"continue", &DebugServer::resume},
      {"next", &DebugServer::next},
      {"stepIn", &DebugServer::step_in},
      {"stepOut", &DebugServer::step_out},
      {"stepBack", &DebugServer::step_back},
      {"reverseContinue", &DebugServer::reverse_continue},
      {"pause", &DebugServer::pause},
      {"cancel", &DebugServer::cancel},
  };
  return all;
}

void DebugServer::stopped(const Stop& stop) {
  Json body{{"reason", stop.reason}, {"threadId", only_thread}, {"allThreadsStopped", true}};
  if (!stop.description.empty()) body["description"] = stop.description;
  if (!stop.text.empty()) body["text"] = stop.text;
  if (!stop.breakpoints.empty()) body["hitBreakpointIds"] = stop.breakpoints;
  send_event("stopped", std::move(body));
}

/// A program with 100,000 warnings must not drown the client.
void DebugServer::told(const Diagnostic& d) {
  {
    const std::lock_guard lock(told_mutex_);
    if (++told_by_code_[d.code] > most_of_one_code) return;
  }
  std::string place = d.where.file;
  if (d.where.line != 0) place += fmt::format(":{}", d.where.line);
  if (d.where.column != 0) place += fmt::format(":{}", d.where.column);
  std::string text = fmt::format("{}: {}: {} [{}]\n", place, to_string(d.severity), d.message, d.code);
  if (!d.hint.empty()) text += "  " + d.hint + "\n";
  Json body{{"category", d.severity == Severity::error ? "stderr" : "console"}, {"output", std::move(text)}};
  if (d.where.line != 0) {
    body["source"] = shown_source(d.where.file);
    body["line"] = d.where.line - 1 + first_line_;
    if (d.where.column != 0) body["column"] = d.where.column - 1 + first_column_;
  }
  send_event("output", std::move(body));
}

void DebugServer::failed(const std::string& why) {
  send_event("output", {{"category", "stderr"}, {"output", "the run has failed: " + why + "\n"}});
}

void DebugServer::logged(const std::string& text, const BlockEntry& entry) {
  send_event("output", {{"category", "console"},
                        {"output", text + "\n"},
                        {"source", shown_source(std::string(entry.file))},
                        {"line", entry.line - 1 + first_line_}});
}

void DebugServer::ended(bool has_errors) {
  {
    const std::lock_guard lock(told_mutex_);
    for (const auto& [code, count] : told_by_code_)
      if (count > most_of_one_code)
        send_event(
            "output",
            {{"category", "console"},
             {"output", fmt::format("{} further diagnostics of {} are not shown\n", count - most_of_one_code, code)}});
  }
  send_event("exited", {{"exitCode", has_errors ? 1 : 0}});
  send_event("terminated", Json::object());
}

}  // namespace isogloss::dap
