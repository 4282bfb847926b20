#include "request.hpp"

#include <map>
#include <tuple>

#include "dialect_guess.hpp"
#include "isogloss/engine/own_dependencies.hpp"

namespace isogloss::python {

namespace {

/// The sink of a workspace that lives on, for the call at hand.
class Forwarding : public DiagnosticSink {
 public:
  void add(Diagnostic diagnostic) override { to->add(std::move(diagnostic)); }
  DiagnosticSink* to = nullptr;
};

/// Loading and linking are one thread's at a time, for all libraries of the process.
std::mutex& loading() {
  static std::mutex mutex;
  return mutex;
}

/// Plugins are loaded once for each set of folders and each trust. Never destroyed, as the plugins are not.
Workspace& shared_workspace(const Request& request, DiagnosticSink& sink) {
  struct Shared {
    Forwarding sink;
    std::unique_ptr<Workspace> workspace;
  };
  using Key = std::tuple<std::string, std::vector<std::string>, std::vector<std::string>, std::vector<std::string>,
                         PluginTrust>;
  static auto& all = *std::make_unique<std::map<Key, Shared>>().release();
  const NamedFolders& f = request.folders;
  Shared& shared = all[{request.home, f.plugins, f.dialects, f.machines, f.trust}];
  if (shared.workspace == nullptr) shared.workspace = std::make_unique<Workspace>(f, request.home, shared.sink);
  shared.sink.to = &sink;
  return *shared.workspace;
}

}  // namespace

PreparedRun::PreparedRun(Request& request, DiagnosticSink& sink) {
  const std::lock_guard lock(loading());
  if (request.syntaxes.empty()) {
    prepare(request, shared_workspace(request, sink));
  } else {
    // The plugin of these syntaxes is this run's alone.
    own_workspace_ = std::make_unique<Workspace>(request.folders, request.home, sink);
    prepare(request, *own_workspace_);
  }
}

void PreparedRun::prepare(Request& request, Workspace& workspace) {
  std::optional<RunOptions> options = request.make(workspace);
  if (!options) return;
  options_ = std::move(*options);
  const std::string dialect = open(request, workspace);
  if (source_ == nullptr || dialect.empty()) return;
  link(request, workspace, dialect);
  if (linked_ != nullptr) add_program_places(request.path, linked_->dialect, options_);
}

/// Returns the dialect, the program's own or the guessed one.
std::string PreparedRun::open(Request& request, Workspace& workspace) {
  std::string_view head;
  if (request.text) {
    source_ = memory_source(*request.text);
    head = std::string_view(*request.text).substr(0, guessed_head_bytes);
  } else {
    std::unique_ptr<OpenedProgram> opened = OpenedProgram::open(request.path, workspace);
    if (opened == nullptr) return {};
    head = opened->head();
    source_ = std::move(opened);
  }
  if (!request.dialect.empty()) return request.dialect;
  const std::optional<Guess> guess = guess_dialect(request.path, head, workspace);
  if (!guess) return {};
  std::string parts;
  if (!guess->next.empty()) {
    DiagnosticList unheard;  // the run itself reports what is wrong
    const auto taken = workspace.link(guess->dialect, options_.chain.dependencies, unheard);
    const auto next = workspace.link(guess->next, options_.chain.dependencies, unheard);
    if (taken != nullptr && next != nullptr) parts = parting(*guess, *taken, *next, request.path, head, options_);
  }
  report_guess(request.path, *guess, parts, workspace);
  return guess->dialect;
}

void PreparedRun::link(Request& request, Workspace& workspace, const std::string& dialect) {
  std::unique_ptr<LinkedDialect> plain = workspace.link(dialect, options_.chain.dependencies);
  if (plain == nullptr || request.syntaxes.empty()) {
    linked_ = std::move(plain);
    return;
  }
  // The types of fields come from the dialect as it is.
  plugin_ = std::make_unique<PythonPlugin>(request.syntaxes, *plain, failure_, workspace);
  Dialect extended = plain->dialect;
  if (plugin_->add_to(extended, workspace)) linked_ = isogloss::link(extended, workspace.library(), workspace.sink());
}

}  // namespace isogloss::python
