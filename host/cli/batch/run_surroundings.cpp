#include "batch/run_surroundings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "chain_trial.hpp"
#include "crash_guard.hpp"
#include "dialect_files.hpp"
#include "isogloss/engine/import.hpp"
#include "outputs.hpp"

namespace isogloss::cli::batch {

namespace fs = std::filesystem;

namespace {

/// Every option that a result may depend on; tables by their contents.
std::string text_of(const BatchArguments& a, FileHashes& hashes) {
  const ProgramOptions& p = a.program;
  std::string out = fmt::format("dialect={}\nmachine={}\nblock-skip={}\noptional-stop={}\nprogram={}\non-error={}\n",
                                p.dialect, p.machine, p.block_skip, p.optional_stop, p.program, p.on_error);
  for (const std::string& table : {p.offsets, p.tools, p.variables}) out += "table=" + hashes.of(table) + "\n";
  for (const std::string& one : p.set) out += "set=" + one + "\n";
  for (const std::string& one : p.subprograms) out += "subprograms=" + one + "\n";
  out += fmt::format("main-passes={}\nlimits={} {} {} {} {} {} {}\n", p.main_passes, p.maximum_depth, p.maximum_jumps,
                     p.maximum_loop_blocks, p.maximum_repeat_blocks, p.maximum_blocks, p.maximum_motions, p.watchdog);
  return out + fmt::format("budgets={} {} {}\nerrors={} {}\ntime={}\nuntrusted={}\n", a.budgets.output_bytes,
                           a.budgets.memory_mib, a.budgets.diagnostics, a.common.maximum_errors,
                           a.common.warnings_are_errors, a.maximum_seconds, a.untrusted.on);
}

/// The results may lie in the folder of the machine.
bool lies_in(const fs::path& file, const fs::path& folder) {
  std::error_code code;
  const fs::path whole = fs::weakly_canonical(file, code);
  fs::path place = fs::weakly_canonical(fs::absolute(folder, code), code);
  if (!place.has_filename()) place = place.parent_path();
  return !place.empty() && std::mismatch(place.begin(), place.end(), whole.begin(), whole.end()).first == place.end();
}

/// Of two files of one name the first folder's counts, so that the order of the folders is part of the text.
std::string text_of_files(const std::vector<Place>& places, const char* extension, const std::string& results,
                          FileHashes& hashes, std::set<std::string>& files) {
  std::string out;
  for (const Place& place : places) {
    std::set<fs::path> found;
    std::error_code error;
    for (fs::directory_iterator at(place.folder, error), end; !error && at != end; at.increment(error))
      if (at->path().extension() == extension && !lies_in(at->path(), results)) found.insert(at->path());
    out += "folder\n";
    for (const fs::path& file : found) {
      out += file.filename().string() + "=" + hashes.of(file.string()) + "\n";
      files.insert(file.string());
    }
  }
  return out;
}

/// False, and reported: there is no such machine any more.
bool add_files_of_machine(const ProgramOptions& program, Session& session, std::set<std::string>& files) {
  if (program.machine.empty()) return true;
  const std::optional<FoundMachine> machine = session.find_machine(program.machine);
  if (!machine) return false;
  for (std::string& file : files_of_machine(machine->file.string())) files.insert(std::move(file));
  return true;
}

/// Those that hold the tables of -m, --tools and the like, included ones, too.
void add_files_of_tables(const std::vector<DependencyElement>& tables, std::set<std::string>& files) {
  for (const DependencyElement& table : tables) {
    files.insert({table.where.file, table.source_file});
    if (table.control_file) files.insert(table.control_file->file.string());
    for (const TableRow& row : table.rows) files.insert(row.where.file);
  }
}

/// Those that a machine or dialect names for its tables and that only a plugin can read.
void add_files_of_controls(const Dialect& dialect, std::set<std::string>& files) {
  DiagnosticList unheard;  // what cannot be read is reported by the process that reads it
  add_files_of_tables(dialect.dependencies, files);
  add_files_of_tables(dialect.own_tables, files);
  for (const Import& import : dialect.imports) {
    std::error_code error;
    if (!fs::is_directory(import.file, error))
      files.insert(import.file.string());
    else
      for (const fs::path& file : files_of(import, unheard)) files.insert(file.string());
  }
}

}  // namespace

std::optional<Surroundings> surroundings_of(const BatchArguments& arguments, FileHashes& hashes, Session& session,
                                            Trial trial) {
  using Completion = RunRequest::Completion;
  ProgramOptions program = arguments.program;
  const auto tables = program.read_tables(session, arguments.untrusted.on ? Completion::none : Completion::by_plugins);
  std::optional<RunOptions> settings = program.make_settings(session);
  if (!tables || !settings) return std::nullopt;
  std::set<std::string> files{"/proc/self/exe"};
  std::string order;
  if (!add_files_of_machine(program, session, files)) return std::nullopt;
  add_files_of_tables(*tables, files);
  // The files of a dialect and its plugins are known once they are loaded, which untrusted ones are in the sandbox
  // only.
  if (program.dialect.empty() || arguments.untrusted.on) {
    order = text_of_files(session.dialect_places(), ".xml", arguments.output, hashes, files) +
            text_of_files(session.plugin_places(), ".so", arguments.output, hashes, files);
    if (fs::path(program.dialect).has_parent_path()) {
      for (std::string& file : files_of_machine(program.dialect)) files.insert(std::move(file));
      order += text_of_files({{fs::path(program.dialect).parent_path(), {}}}, ".xml", arguments.output, hashes, files);
    }
    if (!program.dialect.empty()) {
      const std::optional<Dialect> dialect = session.reader().read(program.dialect, session.sink());
      if (!dialect) return std::nullopt;
      add_files_of_controls(*dialect, files);
    }
  } else {
    std::unique_ptr<LinkedDialect> linked = session.link(program.dialect, *tables);
    if (linked == nullptr) return std::nullopt;
    for (std::string& file : files_of_dialect(linked->dialect)) files.insert(std::move(file));
    for (const LoadedPlugin& plugin : session.library().plugins()) files.insert(plugin.file.string());
    settings->chain.dependencies = *tables;
    bool is_sound = true;
    if (trial == Trial::of_chain) {
      watch_calls(program.watchdog);
      is_sound = can_begin(*linked, settings->chain, session);
      watch_calls(0);
    }
    keep_to_the_end(std::move(linked));
    if (!is_sound) return std::nullopt;
  }
  Surroundings out;
  std::string all = text_of(arguments, hashes) + order;
  for (const std::string& file : files) {
    if (file.empty() || lies_in(file, arguments.output)) continue;
    const std::string& hash = out.files[file] = hashes.of(file);
    all += fs::path(file).filename().string() + "=" + hash + "\n";
  }
  out.hash = hash_of(all).text();
  return out;
}

}  // namespace isogloss::cli::batch
