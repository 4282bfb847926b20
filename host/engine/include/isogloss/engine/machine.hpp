/// Machines: folders that say what one machine has on top of its dialect.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isogloss/engine/dialect.hpp"
#include "isogloss/engine/library.hpp"

namespace isogloss {

/// A machine that was found: NAME/machine.xml; or NAME.xml, which holds tables and names no dialect.
struct FoundMachine {
  std::string name;
  std::string title;
  std::string dialect;  ///< that it stands on
  std::filesystem::path file;
  bool is_tables = false;  ///< holds tables alone, to be used with any dialect
};

/// The machines in these folders, sorted by name; of two with one name the first is listed.
std::vector<FoundMachine> list_machines(const std::vector<std::filesystem::path>& folders);

/// The machine at a path: a folder with machine.xml, or a file. An empty `file` where there is none.
FoundMachine machine_at(const std::filesystem::path& path);

/// Is a part of it still to be read by complete_machine()?
bool is_incomplete(const Dialect& dialect);

/// Completes a dialect or machine that was read, which needs the plugins. Files of controls are imported; the tables of
/// a machine fill those of its dialect: its rows and options win, others stay; each table gets the plugin that has it.
/// False, and reported, on a fault. A complete dialect stays as it is. link() calls this.
bool complete_machine(Dialect& machine, Library& library, DiagnosticSink& given);

}  // namespace isogloss
