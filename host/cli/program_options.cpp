#include "program_options.hpp"

#include <algorithm>
#include <cstring>
#include <map>

#include "dialect_guess.hpp"

namespace isogloss::cli {

namespace {

/// "1" or "1,3": layers from 1 to 9.
bool are_layers(std::string_view text) {
  if (text.size() % 2 == 0) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (i % 2 == 0 ? text[i] < '1' || text[i] > '9' : text[i] != ',') return false;
  return true;
}

}  // namespace

void ProgramOptions::add_to(CommandLine& line) {
  line.option("-d,--dialect", dialect,
              "Dialect, by name or file (default: guessed from text and extension, and reported)")
      .type_name("DIALECT");
  line.option("-m,--machine", machine,
              "Machine, by name, folder or file: it names its dialect; or tables of a machine's axes and kinematics")
      .type_name("MACHINE");
  line.option("--offsets", offsets, "Table of work offsets").type_name("FILE");
  line.option("--tools", tools, "Table of tool offsets").type_name("FILE");
  line.option("--variables", variables, "Table of variables: kept from another run, or known only on the machine")
      .type_name("FILE");
  line.option("--set", set, "One value of a table or dependency, e.g. IsoCoordinateTable.G54.Z=-120 (repeatable)")
      .type_name("NAME=VALUE");
  line.option("--block-skip", block_skip, "Layers of block skip that are on, e.g. 1,3 (default: none)")
      .type_name("LAYERS");
  line.flag("--optional-stop", optional_stop, "Switch the optional stop on");
  line.option("--program", program, "Start at this program of the file (default: the first)").type_name("NAME");
  line.option("--subprograms", subprograms,
              "Where to look for called programs after the program's own file and folder: a folder, or a file of "
              "several programs (repeatable)")
      .type_name("PLACE");
  line.option("--on-error", on_error, "What an alarm of the control does")
      .one_of({"stop", "continue"})
      .type_name("stop|continue")
      .shows_default();
  line.option("--max-blocks", maximum_blocks, "Stop after N blocks (0: never)").type_name("N").shows_default();
  line.option("--max-motions", maximum_motions, "Stop after N blocks and steps of cycles together")
      .type_name("N")
      .shows_default();
  line.option("--main-passes", main_passes,
              "How often to run a main program that starts itself again at its end; 0: until a limit ends the run "
              "(default: as the dialect says, mostly once)")
      .at_least(0)
      .type_name("N");
  line.option("--max-depth", maximum_depth, "How deep program calls may nest").type_name("N").shows_default();
  line.option("--max-jumps", maximum_jumps, "Stop after N calls, returns and jumps").type_name("N").shows_default();
  line.option("--max-loop-blocks", maximum_loop_blocks, "Stop after N blocks that run again after a jump back")
      .type_name("N")
      .shows_default();
  line.option("--max-repeat-blocks", maximum_repeat_blocks,
              "Stop after N blocks that run again because a call repeats its program")
      .type_name("N")
      .shows_default();
  line.option("--watchdog", watchdog, "A block that takes longer is a fault of its syntax (0: never)")
      .type_name("SECONDS")
      .shows_default();
}

std::optional<RunOptions> ProgramOptions::make(Session& session) {
  RunOptions out;
  std::filesystem::path tables_of_machine;
  bool sound = true;
  if (!machine.empty()) {
    const std::optional<FoundMachine> found = session.find_machine(machine);
    if (found && found->is_tables) {
      tables_of_machine = found->file;
    } else {
      const auto named = found ? session.dialect_or_machine(dialect, found->file.string()) : std::nullopt;
      sound = named.has_value();
      dialect = named.value_or(dialect);
    }
  }
  for (const std::filesystem::path& file : {tables_of_machine, std::filesystem::path(offsets),
                                            std::filesystem::path(tools), std::filesystem::path(variables)}) {
    if (file.empty()) continue;
    DiagnosticList said;
    for (DependencyElement& d : session.reader().read_dependencies(file, said))
      out.chain.dependencies.push_back(std::move(d));
    sound = sound && !said.has_errors();
    for (Diagnostic& d : said.all) session.diagnostics().add(std::move(d));
  }
  for (const std::string& assignment : set) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
      session.report("IG-0513", {}, {"--set needs NAME=VALUE, not '" + assignment + "'"});
      sound = false;
    } else {
      out.chain.assignments.emplace_back(assignment.substr(0, equals), assignment.substr(equals + 1));
    }
  }
  if (!block_skip.empty()) {
    if (!are_layers(block_skip)) {
      session.report("IG-0513", {}, {"--block-skip needs layers from 1 to 9 such as 1,3, not '" + block_skip + "'"});
      sound = false;
    }
    out.chain.settings["block-skip"] = block_skip;
  }
  for (const std::string& place : subprograms) {
    std::error_code error;
    const bool is_there = !place.empty() && std::filesystem::exists(place, error);
    if (!is_there) session.report("IG-0510", {place}, {"--subprograms names a folder or a file that is not there"});
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

std::unique_ptr<OpenedProgram> OpenedProgram::open(const std::string& path, Session& session) {
  std::error_code code;
  std::string error;
  std::unique_ptr<Source> rest;
  if (std::filesystem::is_directory(path, code))
    error = "it is a folder";
  else
    rest = open_file(path, error);
  if (rest == nullptr) {
    session.report("IG-0510", {path}, {error});
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
    session.report("IG-0510", {path}, {error});
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

}  // namespace isogloss::cli
