#include "workspace.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

#include "isogloss/engine/own_dependencies.hpp"
#include "isogloss/engine/runner.hpp"

namespace isogloss {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> folders(const std::vector<Place>& places) {
  std::vector<fs::path> out;
  for (const Place& p : places) out.push_back(p.folder);
  return out;
}

/// The user's folders, then the environment's, then those beside the executable or of its installation.
std::vector<Place> places(const std::vector<std::string>& named, const char* option, const char* variable,
                          const fs::path& home, const char* beside, const char* installed) {
  std::vector<Place> out;
  for (const std::string& folder : named) out.push_back({folder, option});
  if (const char* const listed = std::getenv(variable)) {
    std::stringstream list(listed);
    for (std::string folder; std::getline(list, folder, ':');)
      if (!folder.empty()) out.push_back({folder, variable});
  }
  std::error_code ignored;
  if (!home.empty()) {
    if (fs::is_directory(home / beside, ignored)) out.push_back({home / beside, "beside the command"});
    const fs::path own = home.parent_path() / installed;
    if (fs::is_directory(own, ignored) || out.empty()) out.push_back({own, "installation"});
  }
  return out;
}

/// The user's folders, then the environment's, then those of the user's configuration, then those beside the dialects.
std::vector<Place> places_of_machines(const std::vector<std::string>& named, const std::vector<Place>& dialects) {
  std::vector<Place> out;
  for (const std::string& folder : named) out.push_back({folder, "--machines"});
  if (const char* const listed = std::getenv("ISOGLOSS_MACHINES")) {
    std::stringstream list(listed);
    for (std::string folder; std::getline(list, folder, ':');)
      if (!folder.empty()) out.push_back({folder, "ISOGLOSS_MACHINES"});
  }
  const char* const configuration = std::getenv("XDG_CONFIG_HOME");
  const char* const home = std::getenv("HOME");
  if (configuration != nullptr && *configuration == '/')
    out.push_back({fs::path(configuration) / "isogloss/machines", "the user's configuration"});
  else if (home != nullptr && *home == '/')
    out.push_back({fs::path(home) / ".config/isogloss/machines", "the user's configuration"});
  for (const Place& place : dialects) out.push_back({place.folder / "machines", machines_beside_dialects});
  return out;
}

bool loads_any_plugins() {
  const char* const wish = std::getenv("ISOGLOSS_ANY_PLUGINS");
  return wish != nullptr && std::string_view(wish) == "1";
}

}  // namespace

Workspace::Workspace(const NamedFolders& named, const fs::path& home, DiagnosticSink& sink)
    : plugin_places_(
          places(named.plugins, "--plugins", "ISOGLOSS_PLUGIN_PATH", home, "plugins", "lib/isogloss/plugins")),
      dialect_places_(
          places(named.dialects, "--dialects", "ISOGLOSS_DIALECT_PATH", home, "dialects", "share/isogloss/dialects")),
      machine_places_(places_of_machines(named.machines, dialect_places_)),
      library_(named.loads_plugins ? folders(plugin_places_) : std::vector<fs::path>(),
               loads_any_plugins() ? PluginTrust::any : named.trust),
      reader_(folders(dialect_places_)),
      sink_(sink) {}

std::optional<Dialect> Workspace::read(const std::string& name, DiagnosticSink& sink) {
  std::optional<Dialect> dialect = reader_.read(name, sink);
  if (dialect && is_incomplete(*dialect) && !complete_machine(*dialect, library_, sink)) return std::nullopt;
  return dialect;
}

std::vector<FoundMachine> Workspace::machines() const { return list_machines(folders(machine_places_)); }

std::optional<FoundMachine> Workspace::find_machine(const std::string& named) {
  const bool is_path = named.find('/') != std::string::npos || named.ends_with(".xml");
  if (FoundMachine machine = machine_at(named); !machine.file.empty()) return machine;
  std::vector<std::string> names;
  for (FoundMachine& machine : machines()) {
    if (!is_path && machine.name == named) return machine;
    names.push_back(machine.name);
  }
  std::string searched;
  for (const Place& place : machine_places_) searched += (searched.empty() ? "" : ", ") + place.folder.string();
  const std::string near = nearest_name(named, names);
  if (is_path)
    report("IG-0510", {named}, {"it is no file, and no folder with machine.xml"});
  else
    report("IG-0123", {}, {named, searched}, near.empty() ? "" : "did you mean " + near + "?");
  return std::nullopt;
}

std::optional<std::string> Workspace::dialect_or_machine(const std::string& dialect, const std::string& machine) {
  if (machine.empty()) return dialect;
  const std::optional<FoundMachine> found = find_machine(machine);
  if (!found) return std::nullopt;
  if (!dialect.empty())
    report("IG-0513", {}, {"machine " + found->name + " stands on dialect " + found->dialect + "; leave out -d"});
  else if (found->is_tables)
    report("IG-0513", {}, {found->file.string() + " holds tables and names no dialect; this command needs a machine"});
  else
    return found->file.string();
  return std::nullopt;
}

std::unique_ptr<LinkedDialect> Workspace::link(const std::string& name, const std::vector<DependencyElement>& own,
                                               DiagnosticSink& sink) {
  // Notes on the dialect are for its author: `lint` reports them.
  class WithoutNotes : public DiagnosticSink {
   public:
    explicit WithoutNotes(DiagnosticSink& sink) : sink_(sink) {}
    void add(Diagnostic d) override {
      if (d.severity != Severity::note) sink_.add(std::move(d));
    }

   private:
    DiagnosticSink& sink_;
  } without_notes(sink);
  std::optional<Dialect> dialect = read(name, without_notes);
  if (!dialect || !add_missing(own, *dialect, library_, without_notes)) return nullptr;
  return isogloss::link(std::move(*dialect), library_, without_notes);
}

void Workspace::report(std::string_view code, Location where, std::initializer_list<std::string> arguments,
                       std::string hint) {
  sink_.add(host_diagnostic(code, std::move(where), arguments, std::move(hint)));
}

bool is_internal_fault(std::string_view code) {
  constexpr std::array<std::string_view, 6> faults{"IG-0240", "IG-0350", "IG-0401", "IG-0402", "IG-0681", "IG-0683"};
  return std::find(faults.begin(), faults.end(), code) != faults.end();
}

std::optional<std::string> read_text(const std::string& path, std::string& error) {
  std::error_code code;
  if (fs::is_directory(path, code)) {
    error = "it is a folder";
    return std::nullopt;
  }
  const std::unique_ptr<Source> source = open_file(path, error);
  if (source == nullptr) return std::nullopt;
  std::string out;
  char buffer[4096];
  while (const std::size_t n = source->read(buffer, sizeof buffer)) out.append(buffer, n);
  error = source->failure();
  return error.empty() ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace isogloss
