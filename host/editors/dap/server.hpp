/// The debug adapter: requests in, responses and events out. https://microsoft.github.io/debug-adapter-protocol
#pragma once

#include <map>
#include <memory>
#include <set>

#include "dap/state_view.hpp"

namespace isogloss::dap {

using editors::FrameReader;
using editors::FrameWriter;

/// The arguments of "launch": as the options of `isogloss run`, with the same meaning.
struct LaunchArguments {
  std::string program;
  std::string dialect, machine, offsets, tools, variables, block_skip, start_program, main_passes, on_error;
  std::vector<std::string> set, subprograms;
  bool optional_stop = false, stops_on_entry = false, stops_at_end = false, no_debug = false;
  std::uint64_t maximum_blocks = 0, maximum_jumps = 0;  ///< 0: as the command has it
};

/// Reads and links what is launched; empty when it cannot, and the sink knows why. Called on the thread of serve().
using Prepare = std::function<std::optional<DebuggedProgram>(const LaunchArguments&, DiagnosticSink&)>;

class DebugServer : DebugEvents {
 public:
  DebugServer(FrameReader reader, FrameWriter::Write write, Prepare prepare);
  ~DebugServer() override;
  /// Answers until the client disconnects or its stream ends. False: the stream ended within a message, or held none.
  bool serve();

 private:
  struct Answer {
    Json body;
    std::string fault;            ///< a sentence: the request failed
    std::function<void()> after;  ///< done once the answer is written
    bool is_unknown = false;
  };
  using Handler = Answer (DebugServer::*)(const Json& arguments);
  static const std::map<std::string, Handler, std::less<>>& handlers();

  void answer(const Json& request);
  Answer handle(const std::string& command, const Json& arguments);
  void send_event(const std::string& event, Json body);

  void stopped(const Stop& stop) override;
  void told(const Diagnostic& diagnostic) override;
  void failed(const std::string& why) override;
  void logged(const std::string& text, const BlockEntry& entry) override;
  void ended(bool has_errors) override;

  Answer initialize(const Json& arguments);
  Answer launch(const Json& arguments);
  Answer attach(const Json& arguments);
  Answer configuration_done(const Json& arguments);
  Answer restart(const Json& arguments);
  Answer terminate(const Json& arguments);
  Answer disconnect(const Json& arguments);
  Answer set_breakpoints(const Json& arguments);
  Answer set_logic_breakpoints(const Json& arguments);
  Answer set_exception_breakpoints(const Json& arguments);
  Answer breakpoint_locations(const Json& arguments);
  Answer threads(const Json& arguments);
  Answer stack_trace(const Json& arguments);
  Answer scopes(const Json& arguments);
  Answer variables(const Json& arguments);
  Answer set_variable(const Json& arguments);
  Answer set_expression(const Json& arguments);
  Answer evaluate(const Json& arguments);
  Answer exception_info(const Json& arguments);
  Answer loaded_sources(const Json& arguments);
  Answer source(const Json& arguments);
  Answer resume(const Json& arguments);
  Answer next(const Json& arguments);
  Answer step_in(const Json& arguments);
  Answer step_out(const Json& arguments);
  Answer step_back(const Json& arguments);
  Answer reverse_continue(const Json& arguments);
  Answer pause(const Json& arguments);
  Answer cancel(const Json& arguments);

  Answer step(Debuggee::Step step, Json body = Json::object());
  std::optional<std::string> begin(const LaunchArguments& arguments);
  Json verified(const std::string& path, const Json& wanted, BreakpointTable& table);
  Json verified_logic(const Json& wanted, BreakpointTable& table);
  int id_of(const std::string& breakpoint);
  std::map<std::string, Json> make_table();
  Answer assign(const std::string& name, const std::string& value);
  std::string shown_value(const std::string& name);
  bool is_debugged() const { return debuggee_ != nullptr; }

  FrameReader reader_;
  FrameWriter writer_;
  Prepare prepare_;
  std::atomic<std::int64_t> sequence_{0};
  bool is_over_ = false, is_configured_ = false, has_initialized_ = false;
  std::int64_t first_line_ = 1, first_column_ = 1;  // as the client counts
  LaunchArguments launched_;
  std::unique_ptr<Debuggee> debuggee_;
  StateView view_;
  std::map<std::string, Json> line_requests_;  // by the path that the client named
  Json logic_request_ = Json::array();
  std::set<std::string> filters_{"error"};
  std::map<std::string, int> ids_;  // by file and line, or condition: a breakpoint keeps its number
  std::mutex told_mutex_;
  std::map<std::string, std::uint64_t> told_by_code_;
  std::set<std::string> sources_;
};

}  // namespace isogloss::dap
