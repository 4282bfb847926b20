#include "session.hpp"

#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "crash_guard.hpp"
#include "isogloss/engine/own_dependencies.hpp"
#include "isogloss/engine/runner.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

fs::path folder_of_executable() {
  std::error_code error;
  const fs::path exe = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : exe.parent_path();
}

namespace {

std::vector<fs::path> folders(const std::vector<Place>& places) {
  std::vector<fs::path> out;
  for (const Place& p : places) out.push_back(p.folder);
  return out;
}

/// The user's folders, then the environment's, then those beside the executable or of its installation.
std::vector<Place> places(const std::vector<std::string>& named, const char* option, const char* variable,
                          const char* beside, const char* installed) {
  std::vector<Place> out;
  for (const std::string& folder : named) out.push_back({folder, option});
  if (const char* const listed = std::getenv(variable)) {
    std::stringstream list(listed);
    for (std::string folder; std::getline(list, folder, ':');)
      if (!folder.empty()) out.push_back({folder, variable});
  }
  const fs::path home = folder_of_executable();
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
  for (const Place& place : dialects) out.push_back({place.folder / "machines", "beside the dialects"});
  return out;
}

DiagnosticPolicy policy(const CommonOptions& options) {
  DiagnosticPolicy out;
  out.style = options.diagnostics == "json"    ? DiagnosticStyle::json
              : options.diagnostics == "sarif" ? DiagnosticStyle::sarif
                                               : DiagnosticStyle::text;
  out.repeats = options.repeats;
  out.maximum_errors = options.maximum_errors;
  out.warnings_are_errors = options.warnings_are_errors;
  out.colours = options.diagnostics_output.empty() && shows_colours(STDERR_FILENO);
  return out;
}

void write_to_stderr(std::string_view text) {
  const Writing writing;
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace

void CommonOptions::add_to(CommandLine& line) {
  line.option("--plugins", plugins, "Look for plugins in this folder first").type_name("DIR").group("Common");
  line.option("--dialects", dialects, "Look for dialects in this folder first").type_name("DIR").group("Common");
  line.option("--machines", machines, "Look for machines in this folder first").type_name("DIR").group("Common");
  line.option("--diagnostics", diagnostics, "Form of the diagnostics")
      .one_of({"text", "json", "sarif"})
      .type_name("text|json|sarif")
      .shows_default()
      .group("Common");
  line.option("--diagnostics-output", diagnostics_output, "Write diagnostics to a file instead")
      .type_name("FILE")
      .group("Common");
  line.option("--repeats", repeats, "Write N diagnostics of each code in full (0: all)")
      .type_name("N")
      .shows_default()
      .group("Common");
  line.option("--max-errors", maximum_errors, "Stop after N errors (0: never)")
      .type_name("N")
      .shows_default()
      .group("Common");
  line.flag("--werror", warnings_are_errors, "Treat warnings as errors").group("Common");
}

Session::Session(const CommonOptions& options)
    : plugin_places_(places(options.plugins, "--plugins", "ISOGLOSS_PLUGIN_PATH", "plugins", "lib/isogloss/plugins")),
      dialect_places_(
          places(options.dialects, "--dialects", "ISOGLOSS_DIALECT_PATH", "dialects", "share/isogloss/dialects")),
      machine_places_(places_of_machines(options.machines, dialect_places_)),
      library_(folders(plugin_places_)),
      reader_(folders(dialect_places_)),
      diagnostics_output_(options.diagnostics_output),
      diagnostics_(policy(options), [this](std::string_view text) {
        if (taker_) return taker_(text);
        if (diagnostics_file_ != nullptr && diagnostics_file_->write(text)) return;
        progress_.hide();
        write_to_stderr(text);
      }) {
  if (diagnostics_output_.empty()) return;
  std::string error;
  diagnostics_file_ = OutputFile::open(diagnostics_output_, error);
  if (diagnostics_file_ == nullptr) report("IG-0511", {diagnostics_output_}, {error});
}

Session::~Session() {
  diagnostics_.finish();
  if (diagnostics_file_ == nullptr || diagnostics_file_->commit() || diagnostics_file_->reader_is_gone()) return;
  write_to_stderr("isogloss: " + diagnostics_output_ + " cannot be written: " + diagnostics_file_->error() + "\n");
}

std::optional<Dialect> Session::read(const std::string& name, DiagnosticSink& sink) {
  std::optional<Dialect> dialect = reader_.read(name, sink);
  if (dialect && is_incomplete(*dialect) && !complete_machine(*dialect, library_, sink)) return std::nullopt;
  return dialect;
}

std::vector<FoundMachine> Session::machines() const { return list_machines(folders(machine_places_)); }

std::optional<FoundMachine> Session::find_machine(const std::string& named) {
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

std::optional<std::string> Session::dialect_or_machine(const std::string& dialect, const std::string& machine) {
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

std::unique_ptr<LinkedDialect> Session::link(const std::string& name, const std::vector<DependencyElement>& own,
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
  return isogloss::link(*dialect, library_, without_notes);
}

void Session::report(std::string_view code, Location where, std::initializer_list<std::string> arguments,
                     std::string hint) {
  diagnostics_.add(host_diagnostic(code, std::move(where), arguments, std::move(hint)));
}

int Session::status() const {
  // A syntax that threw, and one that broke the contract, are faults inside, not faults of the input.
  const auto& codes = diagnostics_.by_code();
  for (const char* const fault : {"IG-0240", "IG-0350", "IG-0401", "IG-0402"})
    if (codes.contains(fault)) return internal_fault;
  // The program could not be read, or its output could not be written: the same for every input and every output.
  if (codes.contains("IG-0431") || codes.contains("IG-0511")) return cannot_start;
  return diagnostics_.errors() > 0 ? input_errors : success;
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

}  // namespace isogloss::cli
