// Serves an editor as a debug adapter, over standard input and output.
#include <unistd.h>

#include <algorithm>

#include "crash_guard.hpp"
#include "dap/server.hpp"
#include "dialect_guess.hpp"
#include "program_options.hpp"

namespace isogloss::cli {

namespace {

ProgramOptions options_of(const dap::LaunchArguments& wanted, const ProgramOptions& given) {
  ProgramOptions out = given;
  const auto choose = [](std::string& option, const std::string& named) {
    if (!named.empty()) option = named;
  };
  // One of them names the dialect: what the launch names replaces both.
  if (!wanted.dialect.empty() || !wanted.machine.empty()) out.dialect = out.machine = "";
  choose(out.dialect, wanted.dialect);
  choose(out.machine, wanted.machine);
  choose(out.offsets, wanted.offsets);
  choose(out.tools, wanted.tools);
  choose(out.variables, wanted.variables);
  choose(out.block_skip, wanted.block_skip);
  choose(out.program, wanted.start_program);
  choose(out.main_passes, wanted.main_passes);
  choose(out.on_error, wanted.on_error);
  out.set.insert(out.set.end(), wanted.set.begin(), wanted.set.end());
  out.subprograms.insert(out.subprograms.end(), wanted.subprograms.begin(), wanted.subprograms.end());
  out.optional_stop = out.optional_stop || wanted.optional_stop;
  if (wanted.maximum_blocks != 0) out.maximum_blocks = wanted.maximum_blocks;
  if (wanted.maximum_jumps != 0) out.maximum_jumps = wanted.maximum_jumps;
  return out;
}

class Launcher {
 public:
  Launcher(Session& session, const ProgramOptions& given) : session_(session), given_(given) {
    session_.report_to([this](std::string_view text) { said_ += text; });
  }

  std::optional<dap::DebuggedProgram> prepare(const dap::LaunchArguments& wanted, DiagnosticSink& sink) {
    said_.clear();
    std::optional<dap::DebuggedProgram> out = link(wanted, sink);
    while (said_.ends_with('\n')) said_.pop_back();
    if (!out) sink.add({Severity::error, "IG-0510", said_, {wanted.program, 0, 0}, 0, {}});
    return out;
  }

 private:
  std::optional<dap::DebuggedProgram> link(const dap::LaunchArguments& wanted, DiagnosticSink& sink) {
    ProgramOptions options = options_of(wanted, given_);
    std::optional<RunOptions> run = options.make(session_);
    if (!run) return std::nullopt;
    std::string error;
    std::optional<std::string> text = read_text(wanted.program, error);
    if (!text) {
      session_.report("IG-0510", {wanted.program}, {error});
      return std::nullopt;
    }
    std::string dialect = options.dialect;
    if (dialect.empty()) {
      const auto guess = guess_dialect(wanted.program, std::string_view(*text).substr(0, guessed_head_bytes), session_);
      if (!guess) return std::nullopt;
      dialect = guess->dialect;
      sink.add(host_diagnostic("IG-0514", {wanted.program}, {guess->name, guess->why}));
    }
    std::shared_ptr<const LinkedDialect> linked = session_.link(dialect, run->chain.dependencies);
    if (linked == nullptr) return std::nullopt;
    add_program_places(wanted.program, linked->dialect, *run);
    return dap::DebuggedProgram{std::move(linked), std::move(*run), wanted.program, std::move(*text)};
  }

  Session& session_;
  const ProgramOptions& given_;
  std::string said_;
};

}  // namespace

int dap_command(const Arguments& arguments) {
  CommandLine line("dap",
                   "Serves an editor as a debug adapter (Debug Adapter Protocol) over standard input and output: "
                   "breakpoints at lines and conditions, steps through blocks, calls and cycles, forth and back, "
                   "variables. The options hold for each program that is launched, unless the launch names its own.",
                   "isogloss dap -d fanuc");
  CommonOptions common;
  ProgramOptions program;
  program.add_to(line);
  common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  Session session(common);
  Launcher launcher(session, program);
  watch_calls(program.watchdog);
  dap::DebugServer server(
      editors::FrameReader(editors::read_from(STDIN_FILENO)), editors::write_to(STDOUT_FILENO),
      [&](const dap::LaunchArguments& wanted, DiagnosticSink& sink) { return launcher.prepare(wanted, sink); });
  return server.serve() ? success : input_errors;
}

}  // namespace isogloss::cli
