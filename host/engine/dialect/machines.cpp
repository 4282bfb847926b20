// Finds machines, and completes one that was read.
#include "isogloss/engine/machine.hpp"

#include <algorithm>
#include <map>

#include "dialect/dialect_file.hpp"
#include "dialect/row_checks.hpp"
#include "isogloss/engine/own_dependencies.hpp"

namespace isogloss {

namespace fs = std::filesystem;

namespace {

bool is_readable_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// Rows of several files with one key become one row, in which the later file's cells win.
void merge_rows(const ig_dependency& dependency, std::vector<TableRow>& rows) {
  std::map<std::string, std::size_t> first;
  std::vector<TableRow> merged;
  for (TableRow& row : rows) {
    const std::string key(key_of(dependency, row));
    const auto [same, is_new] = first.emplace(key, merged.size());
    // Two rows of one file are a mistake, which the checks report.
    if (is_new || key.empty() || merged[same->second].where.file == row.where.file) {
      merged.push_back(std::move(row));
      continue;
    }
    TableRow& older = merged[same->second];
    for (Attribute& cell : row.attributes) {
      const auto old = std::find_if(older.attributes.begin(), older.attributes.end(),
                                    [&](const Attribute& a) { return a.name == cell.name; });
      if (old == older.attributes.end())
        older.attributes.push_back(std::move(cell));
      else
        *old = std::move(cell);
    }
    older.where = row.where;
  }
  rows = std::move(merged);
}

}  // namespace

FoundMachine machine_at(const fs::path& path) {
  std::error_code error;
  const fs::path file = fs::is_directory(path, error) ? path / "machine.xml" : path;
  if (!is_readable_file(file)) return {};
  const bool is_of_folder = file.filename() == "machine.xml";
  const fs::path named = is_of_folder ? fs::absolute(file, error).parent_path().filename() : file.stem();
  FoundMachine out{named.string(), "", "", file, !is_of_folder};
  // What is wrong with the file is reported when it is read as a machine, or as tables.
  DiagnosticList unheard;
  XmlBudget budget;
  const std::unique_ptr<XmlSource> xml = XmlSource::open(file, {}, budget, unheard, Pipes::read);
  if (xml == nullptr || std::string_view(xml->root().name()) != "Machine") return out;
  out.is_tables = false;
  out.title = xml->root().attribute("title").value();
  out.dialect = xml->root().attribute("dialect").value();
  return out;
}

std::vector<FoundMachine> list_machines(const std::vector<fs::path>& folders) {
  std::map<std::string, FoundMachine> found;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
      std::error_code ignored;
      const bool is_folder = it->is_directory(ignored);
      if (!is_folder && it->path().extension() != ".xml") continue;
      FoundMachine machine = machine_at(it->path());
      if (!machine.file.empty()) found.emplace(machine.name, std::move(machine));
    }
  }
  std::vector<FoundMachine> out;
  for (auto& [name, machine] : found) out.push_back(std::move(machine));
  return out;
}

bool complete_machine(Dialect& machine, Library& library, DiagnosticSink& sink) {
  for (const PluginReference& plugin : machine.plugins)
    if (!library.load(plugin.name, plugin.where, sink)) return false;
  bool is_sound = true;
  for (DependencyElement& element : machine.dependencies) {
    is_sound = add_plugin_of(element, machine, library, sink) && is_sound;
    if (const ig_dependency* const dependency = library.dependency(element.id)) merge_rows(*dependency, element.rows);
  }
  return is_sound;
}

}  // namespace isogloss
