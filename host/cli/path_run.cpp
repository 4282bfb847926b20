#include "path_run.hpp"

#include <filesystem>
#include <stdexcept>

#include "crash_guard.hpp"
#include "dialect_guess.hpp"

namespace isogloss::cli {

void KeptReports::add(Diagnostic diagnostic) {
  ++number;
  if (kept.size() < most_) kept.push_back(diagnostic);
  sink_.add(std::move(diagnostic));
}

std::unique_ptr<PathRun> run_path(const KeptProgram& program, ProgramOptions options, const ToolPathOptions& path,
                                  const RunBudgets& budgets, Session& session) {
  auto out = std::make_unique<PathRun>(session.diagnostics());
  std::optional<RunOptions> made = options.make(session);
  if (!made) return nullptr;
  if (options.dialect.empty()) {
    const std::optional<std::string> guess = guessed(program.path(), program.head(session), session);
    if (!guess) return nullptr;
    options.dialect = *guess;
  }
  out->linked = session.link(options.dialect, made->chain.dependencies);
  const std::unique_ptr<Source> source = program.source(session);
  if (out->linked == nullptr || source == nullptr) return nullptr;
  add_program_places(program.path(), out->linked->dialect, *made);
  out->options = *made;
  watch_calls(options.watchdog);
  made->goes_on = [&] { return budgets.hold(program.path(), session); };
  std::error_code code;
  const bool is_file = std::filesystem::is_regular_file(program.path(), code);
  const std::uintmax_t size = is_file ? std::filesystem::file_size(program.path(), code) : 0;
  made->progress = [&](std::uint64_t, std::uint64_t bytes) { session.progress().show(bytes, size, program.path()); };
  try {
    const auto recorder = make_path_recorder(out->path, rapid_rates(*out->linked, made->chain), path);
    out->blocks = isogloss::run(*out->linked, *source, program.path(), *made, {recorder.get()}, out->reports).blocks;
  } catch (const std::runtime_error& e) {
    session.progress().hide();
    if (session.diagnostics().errors() == 0) session.report("IG-0513", {program.path()}, {e.what()});
    return nullptr;  // a syntax could not be created
  }
  session.progress().hide();
  if (out->path.is_cut) session.report("IG-0650", {program.path()}, {std::to_string(out->path.moves.size())});
  return out;
}

}  // namespace isogloss::cli
