#include "run_request.hpp"

#include <algorithm>
#include <cstring>
#include <map>

#include "dialect_guess.hpp"
#include "isogloss/engine/machine.hpp"

namespace isogloss {

namespace {

/// "1" or "1,3": layers from 1 to 9.
bool are_layers(std::string_view text) {
  if (text.size() % 2 == 0) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (i % 2 == 0 ? text[i] < '1' || text[i] > '9' : text[i] != ',') return false;
  return true;
}

}  // namespace

std::optional<std::vector<DependencyElement>> RunRequest::read_tables(Workspace& workspace, Completion completion) {
  std::filesystem::path tables_of_machine;
  bool sound = true;
  if (!machine.empty()) {
    const std::optional<FoundMachine> found = workspace.find_machine(machine);
    if (found && found->is_tables) {
      tables_of_machine = found->file;
    } else {
      const auto named = found ? workspace.dialect_or_machine(dialect, found->file.string()) : std::nullopt;
      sound = named.has_value();
      dialect = named.value_or(dialect);
    }
  }
  std::vector<DependencyElement> out;
  for (const std::filesystem::path& file : {tables_of_machine, std::filesystem::path(offsets),
                                            std::filesystem::path(tools), std::filesystem::path(variables)}) {
    if (file.empty()) continue;
    DiagnosticList said;
    Dialect tables;
    tables.dependencies = workspace.reader().read_dependencies(file, said);
    if (completion == Completion::by_plugins && is_incomplete(tables))
      complete_machine(tables, workspace.library(), said);
    for (DependencyElement& d : tables.dependencies) out.push_back(std::move(d));
    sound = sound && !said.has_errors();
    for (Diagnostic& d : said.all) workspace.sink().add(std::move(d));
  }
  return sound ? std::optional(std::move(out)) : std::nullopt;
}

std::optional<RunOptions> RunRequest::make(Workspace& workspace) {
  std::optional<std::vector<DependencyElement>> tables = read_tables(workspace, Completion::by_plugins);
  std::optional<RunOptions> out = make_settings(workspace);
  if (!tables || !out) return std::nullopt;
  out->chain.dependencies = std::move(*tables);
  return out;
}

std::optional<RunOptions> RunRequest::make_settings(Workspace& workspace) const {
  RunOptions out;
  bool sound = true;
  for (const std::string& assignment : set) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
      workspace.report("IG-0513", {}, {"--set needs NAME=VALUE, not '" + assignment + "'"});
      sound = false;
    } else {
      out.chain.assignments.emplace_back(assignment.substr(0, equals), assignment.substr(equals + 1));
    }
  }
  if (!block_skip.empty()) {
    if (!are_layers(block_skip)) {
      workspace.report("IG-0513", {}, {"--block-skip needs layers from 1 to 9 such as 1,3, not '" + block_skip + "'"});
      sound = false;
    }
    out.chain.settings["block-skip"] = block_skip;
  }
  for (const std::string& place : subprograms) {
    std::error_code error;
    const bool is_there = !place.empty() && std::filesystem::exists(place, error);
    if (!is_there) workspace.report("IG-0510", {place}, {"--subprograms names a folder or a file that is not there"});
    sound = sound && is_there;
  }
  if (!main_passes.empty()) out.chain.settings["main-passes"] = main_passes;
  out.program_places = subprograms;
  out.maximum_depth = maximum_depth;
  out.maximum_jumps = maximum_jumps;
  out.maximum_loop_blocks = maximum_loop_blocks;
  out.maximum_repeat_blocks = maximum_repeat_blocks;
  if (optional_stop) out.chain.settings["optional-stop"] = "on";
  if (!program.empty()) out.chain.settings["program"] = program;
  out.program = program;
  out.stop_on_error = on_error == "stop";
  out.maximum_blocks = maximum_blocks;
  out.maximum_motions = maximum_motions;
  return sound ? std::optional(std::move(out)) : std::nullopt;
}

void add_program_places(const std::string& program, const Dialect& dialect, RunOptions& options) {
  if (program != "-")
    options.program_places.insert(options.program_places.begin(),
                                  std::filesystem::path(program).parent_path().string());
  for (const std::filesystem::path& place : dialect.program_places) options.program_places.push_back(place.string());
}

std::unique_ptr<OpenedProgram> OpenedProgram::open(const std::string& path, Workspace& workspace) {
  std::error_code code;
  std::string error;
  std::unique_ptr<Source> rest;
  if (std::filesystem::is_directory(path, code))
    error = "it is a folder";
  else
    rest = open_file(path, error);
  if (rest == nullptr) {
    workspace.report("IG-0510", {path}, {error});
    return nullptr;
  }
  std::string head(guessed_head_bytes, '\0');
  std::size_t size = 0;
  while (size < head.size()) {
    const std::size_t n = rest->read(head.data() + size, head.size() - size);
    if (n == 0) break;
    size += n;
  }
  head.resize(size);
  if (error = rest->failure(); !error.empty()) {
    workspace.report("IG-0510", {path}, {error});
    return nullptr;
  }
  return std::unique_ptr<OpenedProgram>(new OpenedProgram(std::move(rest), std::move(head)));
}

std::size_t OpenedProgram::read(char* buffer, std::size_t size) {
  const std::size_t n = std::min(size, head_.size() - given_);
  if (n == 0) return rest_->read(buffer, size);
  std::memcpy(buffer, head_.data() + given_, n);
  given_ += n;
  return n;
}

}  // namespace isogloss
