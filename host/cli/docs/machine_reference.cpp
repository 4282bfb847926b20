// What the reference shows of a machine. Paths are shown from the machine's own folder, because that folder lies
// elsewhere on each computer.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "docs/reference.hpp"

namespace isogloss::cli::docs {

namespace fs = std::filesystem;

namespace {

std::string shown_path(const fs::path& path, const fs::path& folder) {
  const fs::path relative = path.lexically_relative(folder);
  const bool is_inside = !relative.empty() && *relative.begin() != "..";
  return is_inside ? relative.string() : path.filename().string();
}

Json table(const DependencyElement& e, const fs::path& folder) {
  Json options = Json::object(), rows = Json::array();
  for (const Attribute& option : e.options) options[option.name] = option.value;
  for (const TableRow& row : e.rows) {
    Json values = Json::object();
    for (const Attribute& cell : row.attributes) values[cell.name] = cell.value;
    rows.push_back({{"Values", std::move(values)},
                    {"From", fmt::format("{}:{}", shown_path(row.where.file, folder), row.where.line)}});
  }
  return {{"Id", e.id}, {"As", e.alias}, {"Options", std::move(options)}, {"Rows", std::move(rows)}};
}

Json programs_in(const fs::path& place, const fs::path& folder) {
  constexpr std::size_t most = 200;
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator it(place, error), end; !error && it != end && files.size() < most; it.increment(error))
    if (it->is_regular_file(error)) files.push_back(it->path().filename().string());
  std::sort(files.begin(), files.end());
  return {{"Folder", shown_path(place, folder)}, {"Files", files}};
}

/// The table that names the axes.
std::string axis_table(const LinkedDialect& linked) {
  for (const LinkedDependency& d : linked.dependencies)
    for (const char* const* id = d.dependency->provides; id != nullptr && *id != nullptr; ++id)
      if (std::string_view(*id) == "isogloss.axis-name/1") return d.dependency->id;
  return {};
}

}  // namespace

ShownMachine show_machine(const FoundMachine& found, Session& session) {
  ShownMachine out;
  out.name = found.name;
  out.title = found.title;
  out.file = found.file.filename().string();
  out.dialect = found.dialect;
  out.is_tables = found.is_tables;
  const fs::path folder = found.file.parent_path();
  if (found.is_tables) {
    DiagnosticList said;
    for (const DependencyElement& e : session.reader().read_dependencies(found.file, said))
      out.tables.push_back(table(e, folder));
    out.is_whole = !said.has_errors();
    for (Diagnostic& d : said.all) session.diagnostics().add(std::move(d));
    return out;
  }
  const std::unique_ptr<LinkedDialect> linked = session.link(found.file.string());
  if (linked == nullptr) return out;
  out.is_whole = true;
  const Json described = describe_machine(*linked, session.library());
  out.axes = described["Axes"];
  out.lacks = described["Lacks"];
  out.axis_table = axis_table(*linked);
  for (const DependencyElement& e : linked->dialect.dependencies)
    if (!e.rows.empty() || !e.options.empty()) out.tables.push_back(table(e, folder));
  for (const fs::path& place : linked->dialect.program_places) out.programs.push_back(programs_in(place, folder));
  return out;
}

}  // namespace isogloss::cli::docs
