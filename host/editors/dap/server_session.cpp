// From initialize to disconnect.
#include <filesystem>
#include <utility>

#include "dap/arguments.hpp"
#include "dap/server.hpp"

namespace isogloss::dap {

namespace {

std::optional<LaunchArguments> read_launch(const Json& a, std::string& fault) {
  LaunchArguments out;
  out.program = text_of(a, "program");
  out.dialect = text_of(a, "dialect");
  out.machine = text_of(a, "machine");
  out.offsets = text_of(a, "offsets");
  out.tools = text_of(a, "tools");
  out.variables = text_of(a, "variables");
  out.block_skip = text_of(a, "blockSkip");
  out.start_program = text_of(a, "startProgram");
  out.on_error = text_of(a, "onError");
  out.set = texts_of(a, "set");
  out.subprograms = texts_of(a, "subprograms");
  out.optional_stop = flag_of(a, "optionalStop");
  out.stops_on_entry = flag_of(a, "stopOnEntry");
  out.stops_at_end = flag_of(a, "stopAtEnd");
  out.no_debug = flag_of(a, "noDebug");
  if (const auto passes = integer_of(a, "mainPasses")) out.main_passes = std::to_string(*passes);
  out.maximum_blocks = static_cast<std::uint64_t>(std::max<std::int64_t>(integer_of(a, "maxBlocks").value_or(0), 0));
  out.maximum_jumps = static_cast<std::uint64_t>(std::max<std::int64_t>(integer_of(a, "maxJumps").value_or(0), 0));
  if (out.program.empty()) fault = "launch needs \"program\": the path of a part program";
  if (!out.on_error.empty() && out.on_error != "stop" && out.on_error != "continue")
    fault = "onError is \"stop\" or \"continue\", not \"" + out.on_error + "\"";
  return fault.empty() ? std::optional(std::move(out)) : std::nullopt;
}

Json capabilities() {
  Json filters = Json::array();
  filters.push_back({{"filter", "error"},
                     {"label", "Errors"},
                     {"default", true},
                     {"description", "Stop behind a block that raises an error"}});
  filters.push_back({{"filter", "warning"},
                     {"label", "Warnings"},
                     {"default", false},
                     {"description", "Stop behind a block that raises a warning"}});
  Json out{{"exceptionBreakpointFilters", std::move(filters)}};
  for (const char* const able :
       {"supportsConfigurationDoneRequest", "supportsFunctionBreakpoints", "supportsConditionalBreakpoints",
        "supportsHitConditionalBreakpoints", "supportsEvaluateForHovers", "supportsStepBack", "supportsSetVariable",
        "supportsSetExpression", "supportsRestartRequest", "supportsExceptionInfoRequest", "supportsTerminateRequest",
        "supportsLogPoints", "supportsBreakpointLocationsRequest", "supportsLoadedSourcesRequest",
        "supportsCancelRequest", "supportTerminateDebuggee"})
    out[able] = true;
  return out;
}

/// What linking reports, in one text.
struct Reasons : DiagnosticSink {
  void add(Diagnostic d) override {
    if (d.severity == Severity::error) errors += (errors.empty() ? "" : "; ") + d.message + " [" + d.code + "]";
    all.push_back(std::move(d));
  }
  std::string errors;
  std::size_t count = 0;
  std::vector<Diagnostic> all;
};

}  // namespace

DebugServer::Answer DebugServer::initialize(const Json& arguments) {
  if (has_initialized_) return {{}, "initialize was sent already", {}, false};
  has_initialized_ = true;
  const auto counts_from_one = [&](const char* name) {
    const auto found = arguments.find(name);
    return found == arguments.end() || !found->is_boolean() || found->get<bool>();
  };
  first_line_ = counts_from_one("linesStartAt1") ? 1 : 0;
  first_column_ = counts_from_one("columnsStartAt1") ? 1 : 0;
  return {capabilities(), "", {}, false};
}

/// The run begins with configurationDone; "initialized" comes now, when breakpoints can be verified.
DebugServer::Answer DebugServer::launch(const Json& arguments) {
  if (is_debugged()) return {{}, "a program is launched already: restart or disconnect first", {}, false};
  std::string fault;
  const std::optional<LaunchArguments> wanted = read_launch(arguments, fault);
  if (!wanted) return {{}, fault, {}, false};
  if (const auto why = begin(*wanted)) return {{}, *why, {}, false};
  return {{}, "", [this] { send_event("initialized", Json::object()); }, false};
}

/// Reads, links and waits; a sentence when it cannot.
std::optional<std::string> DebugServer::begin(const LaunchArguments& arguments) {
  Reasons reasons;
  told_by_code_.clear();
  std::optional<DebuggedProgram> program = prepare_(arguments, reasons);
  for (const Diagnostic& d : reasons.all)
    if (program || d.severity != Severity::error) told(d);
  if (!program) return reasons.errors.empty() ? "the program cannot be launched" : reasons.errors;
  launched_ = arguments;
  program->stops_on_entry = arguments.stops_on_entry && !arguments.no_debug;
  program->stops_at_end = arguments.stops_at_end && !arguments.no_debug;
  sources_ = {canonical_path(program->path)};
  debuggee_ = std::make_unique<Debuggee>(std::move(*program), static_cast<DebugEvents&>(*this));
  make_table();
  return std::nullopt;
}

DebugServer::Answer DebugServer::attach(const Json&) {
  return {{}, "there is no running program to attach to: launch one", {}, false};
}

DebugServer::Answer DebugServer::configuration_done(const Json&) {
  if (!is_debugged()) return {{}, "no program is launched", {}, false};
  if (std::exchange(is_configured_, true)) return {{}, "the run has begun already", {}, false};
  return {{}, "", [this] { debuggee_->start(); }, false};
}

/// The program is read again: an editor restarts after a change.
DebugServer::Answer DebugServer::restart(const Json& arguments) {
  if (!is_debugged()) return {{}, "no program is launched", {}, false};
  LaunchArguments wanted = launched_;
  if (const auto given = arguments.find("arguments"); given != arguments.end() && given->is_object()) {
    std::string fault;
    const std::optional<LaunchArguments> other = read_launch(*given, fault);
    if (!other) return {{}, fault, {}, false};
    wanted = *other;
  }
  debuggee_->quit();
  debuggee_.reset();
  view_.forget();
  if (const auto why = begin(wanted)) return {{}, *why, [this] { send_event("terminated", Json::object()); }, false};
  is_configured_ = true;
  return {{}, "", [this] { debuggee_->start(); }, false};
}

DebugServer::Answer DebugServer::terminate(const Json&) {
  if (!is_debugged()) return {{}, "no program is launched", {}, false};
  debuggee_->quit();
  debuggee_.reset();
  return {{}, "", [this] { send_event("terminated", Json::object()); }, false};
}

DebugServer::Answer DebugServer::disconnect(const Json&) {
  if (is_debugged()) debuggee_->quit();
  debuggee_.reset();
  is_over_ = true;
  return {};
}

DebugServer::Answer DebugServer::cancel(const Json&) { return {}; }

DebugServer::Answer DebugServer::loaded_sources(const Json&) {
  if (is_debugged())
    debuggee_->look([&](const Standing& standing, const ProgramVariables&) {
      for (const ExplainedFrame& frame : *standing.entry.frames) sources_.insert(canonical_path(frame.file));
    });
  Json out = Json::array();
  for (const std::string& path : sources_)
    out.push_back({{"name", std::filesystem::path(path).filename().string()}, {"path", path}});
  return {{{"sources", std::move(out)}}, "", {}, false};
}

DebugServer::Answer DebugServer::source(const Json&) {
  return {{}, "all sources are files: read them at their paths", {}, false};
}

}  // namespace isogloss::dap
