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

/// Completes a machine that was read, which needs the plugins: each table gets the plugin that has it, and a row of the
/// machine becomes one with the row of its dialect that has the same key. False, and reported, when no plugin has one.
bool complete_machine(Dialect& machine, Library& library, DiagnosticSink& sink);

}  // namespace isogloss
