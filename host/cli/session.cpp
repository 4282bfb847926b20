#include "session.hpp"

#include <sys/auxv.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "crash_guard.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

fs::path folder_of_executable() {
  std::error_code error;
  const fs::path exe = fs::read_symlink("/proc/self/exe", error);
  if (!error) return exe.parent_path();
  // Without /proc, the name by which the command was started, as long as it names a file.
  const auto* const name = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
  if (name == nullptr) return {};
  const fs::path started = fs::canonical(name, error);
  return error ? fs::path() : started.parent_path();
}

namespace {

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

/// Told at the end of the session, when its command has returned its status already.
bool are_diagnostics_lost = false;

/// A reader that went away, or was never there, is no fault.
void write_to_stderr(std::string_view text) {
  const Writing writing;
  const bool is_out = std::fwrite(text.data(), 1, text.size(), stderr) == text.size();
  are_diagnostics_lost = are_diagnostics_lost || (!is_out && errno != EPIPE && errno != EBADF);
}

}  // namespace

void CommonOptions::add_to(CommandLine& line) {
  line.option("--plugins", plugins, "Look for plugins in this folder first").type_name("DIR").group("Common");
  line.option("--dialects", dialects, "Look for dialects in this folder first").type_name("DIR").group("Common");
  line.option("--machines", machines, "Look for machines in this folder first").type_name("DIR").group("Common");
  line.flag("--any-plugins", any_plugins, "Load plugins that other users can write or replace, too").group("Common");
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
    : Workspace({options.plugins, options.dialects, options.machines,
                 options.any_plugins ? PluginTrust::any : PluginTrust::guarded, options.loads_plugins},
                folder_of_executable(), diagnostics_),
      diagnostics_output_(options.diagnostics_output),
      diagnostics_(policy(options), [this](std::string_view text) {
        if (taker_) return taker_(text);
        if (diagnostics_file_ != nullptr && diagnostics_file_->write(text)) return;
        progress_.hide();
        write_to_stderr(text);
      }) {
  std::string error;
  if (!diagnostics_output_.empty()) diagnostics_file_ = OutputFile::open(diagnostics_output_, error);
  if (!diagnostics_output_.empty() && diagnostics_file_ == nullptr) {
    are_diagnostics_lost = true;
    report("IG-0511", {diagnostics_output_}, {error});
  }
  if (folder_of_executable().empty()) report("IG-0610", {}, {"plugins and dialects"});
  if (!options.tells_missing_folders) return;
  for (const std::vector<Place>* const places : {&plugin_places(), &dialect_places(), &machine_places()})
    for (const Place& place : *places) {
      const bool is_asked_for = place.named_by.starts_with("--") || place.named_by.starts_with("ISOGLOSS_");
      if (std::error_code ignored; is_asked_for && !fs::is_directory(place.folder, ignored))
        report("IG-0612", {}, {place.named_by, place.folder.string()});
    }
}

Session::~Session() {
  diagnostics_.finish();
  if (diagnostics_file_ == nullptr || diagnostics_file_->commit() || diagnostics_file_->reader_is_gone()) return;
  are_diagnostics_lost = true;
  write_to_stderr("isogloss: " + diagnostics_output_ + " cannot be written: " + diagnostics_file_->error() + "\n");
}

bool diagnostics_were_lost() { return are_diagnostics_lost; }

int Session::status() const {
  const auto& codes = diagnostics_.by_code();
  if (std::any_of(codes.begin(), codes.end(), [](const auto& of_code) { return is_internal_fault(of_code.first); }))
    return internal_fault;
  // The program could not be read, or its output could not be written: the same for every input and every output.
  if (codes.contains("IG-0431") || codes.contains("IG-0511")) return cannot_start;
  return diagnostics_.errors() > 0 ? input_errors : success;
}

}  // namespace isogloss::cli
