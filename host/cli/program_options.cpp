#include "program_options.hpp"

namespace isogloss::cli {

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
      .type_name("NAME=VALUE")
      .names_once();
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

std::vector<std::string> ProgramOptions::files() const {
  std::vector<std::string> out = {dialect, machine, offsets, tools, variables};
  out.insert(out.end(), subprograms.begin(), subprograms.end());
  return out;
}

bool ProgramOptions::take_side(const std::string& own_dialect, const std::string& own_machine, Workspace& workspace) {
  if (!own_machine.empty()) machine = own_machine;
  if (!own_dialect.empty()) dialect = own_dialect;
  if (machine.empty()) return true;
  const std::optional<FoundMachine> found = workspace.find_machine(machine);
  if (!found || found->is_tables) return found.has_value();
  if (!own_machine.empty())
    dialect = own_dialect;
  else if (!own_dialect.empty())
    machine.clear();
  return true;
}

bool ProgramOptions::serves_a_side(const std::array<std::string, 2>& own_dialects,
                                   const std::array<std::string, 2>& own_machines, Workspace& workspace) const {
  if (dialect.empty() && machine.empty()) return true;
  bool uses_dialect = false, uses_machine = false;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string& named = own_machines[side].empty() ? machine : own_machines[side];
    const std::optional<FoundMachine> found = named.empty() ? std::nullopt : workspace.find_machine(named);
    if (!named.empty() && !found) return false;
    const bool names_dialect = found && !found->is_tables;
    uses_dialect = uses_dialect || (own_dialects[side].empty() && (own_machines[side].empty() || !names_dialect));
    uses_machine = uses_machine || (own_machines[side].empty() && (own_dialects[side].empty() || !names_dialect));
  }
  const auto refuse = [&](const std::string& option) {
    workspace.report(
        "IG-0513", {},
        {option + " has no effect: each side has a dialect or a machine of its own; leave " + option + " out"});
    return false;
  };
  if (!dialect.empty() && !uses_dialect) return refuse("-d");
  return machine.empty() || uses_machine || refuse("-m");
}

}  // namespace isogloss::cli
