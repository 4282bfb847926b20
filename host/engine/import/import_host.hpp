/// What the host does for an importer while it reads or writes a file.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "isogloss/engine/import.hpp"
#include "isogloss/engine/linker.hpp"

namespace isogloss {

/// A cell that came again in the file with another value.
struct ReplacedCell {
  std::string key;  // of its row
  Attribute earlier, later;
};

}  // namespace isogloss

/// The opaque types of the contract.
struct ig_import {
  const isogloss::Import& asked;
  const ig_importer& importer;
  const ig_plugin& plugin;
  isogloss::Library& library;
  isogloss::DiagnosticSink& sink;
  const std::string& text;  // UTF-8
  const std::string& name;
  const std::vector<isogloss::OptionValue>& options;
  isogloss::ImportedFile out;
  std::map<std::string, std::size_t> tables;                          // by dependency: place in out.tables
  std::vector<std::map<std::string, std::size_t>> rows;               // by table and key: place in its rows
  std::map<std::pair<std::string, std::string>, std::size_t> unused;  // by its two texts: place in out.unused
  isogloss::TableRow* row = nullptr;                                  // that cells belong to
  std::string failure;
  bool is_sound = true;
  std::size_t cells = 0;
  std::vector<isogloss::ReplacedCell> replaced{};
  std::set<std::uint32_t> reported_lines{};  // where the importer itself reported something
  std::vector<std::size_t> line_begins{};    // of all lines, found with the first place
};

struct ig_export {
  const std::vector<isogloss::DependencyElement>& tables;
  isogloss::Library& library;
  const std::vector<isogloss::OptionValue>& options;
  std::vector<isogloss::UnusedPart>& unused;
  std::string out;
  std::string failure;
  std::map<std::pair<std::string, std::string>, std::size_t> known_unused{};  // by its two texts: place in `unused`
  /// The columns, by dependency, whose cells the importer asked for; none where it asked for keys alone.
  mutable std::map<std::string, std::set<std::string>, std::less<>> asked{};
};

namespace isogloss {

const ig_import_api& import_api();
const ig_export_api& export_api();

/// Reports cells that came again with another value, except on lines of which the importer itself reported something.
void report_replaced(const ig_import& in);

/// Names what the importer never asked for of its dependencies, as the file lacks it: whole tables, and columns.
void name_unasked(ig_export& out, const char* const* dependencies);

}  // namespace isogloss
