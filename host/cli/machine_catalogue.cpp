// What a machine has, and what it lacks for its dialect.
#include <map>
#include <set>

#include "catalogue.hpp"

namespace isogloss::cli {

namespace {

/// The rows of a table by the files that give them, in the order of the rows.
Json sources(const DependencyElement& element) {
  std::map<std::string, std::size_t> rows;
  std::vector<std::string> files;
  const auto add = [&](const std::string& file, std::size_t count) {
    const auto [found, is_new] = rows.emplace(file, 0);
    found->second += count;
    if (is_new) files.push_back(file);
  };
  if (element.rows.empty()) add(element.where.file, 0);
  for (const TableRow& row : element.rows) add(row.where.file, 1);
  Json out = Json::array();
  for (const std::string& file : files) out.push_back({{"Table", element.alias}, {"Rows", rows[file]}, {"File", file}});
  return out;
}

/// Services that syntaxes ask for, that no table of the machine answers and that some dependency could.
Json lacking(const LinkedDialect& linked, const Library& library) {
  std::set<std::string, std::less<>> answered, asked;
  for (const Provision& p : provisions(linked)) answered.insert(p.service);
  for (const LinkedSyntax& s : linked.chain)
    for (std::uint32_t i = 0; i < s.syntax->service_count; ++i) asked.insert(s.syntax->services[i].id);
  std::map<std::string, Json> offered;
  for (const LoadedPlugin& p : library.plugins())
    for (std::uint32_t i = 0; i < p.plugin->dependency_count; ++i) {
      const ig_dependency& d = *p.plugin->dependencies[i];
      for (const char* const* id = d.provides; id != nullptr && *id != nullptr; ++id)
        if (asked.contains(*id) && !answered.contains(*id))
          offered.emplace(*id, Json::array()).first->second.push_back(d.id);
    }
  Json out = Json::array();
  for (auto& [service, tables] : offered) out.push_back({{"Service", service}, {"Offered by", std::move(tables)}});
  return out;
}

}  // namespace

Json describe(const FoundMachine& m) {
  Json out{{"Name", m.name}, {"Title", m.title}, {"File", m.file.string()}};
  out["Dialect"] = m.is_tables ? "any: it holds tables alone" : m.dialect;
  return out;
}

Json describe_machine(const LinkedDialect& linked, const Library& library) {
  const Dialect& d = linked.dialect;
  Json out{{"Name", d.name}, {"Title", d.title}, {"File", d.file.string()}, {"Dialect", d.ancestors}};
  Json tables = Json::array(), programs = Json::array();
  for (const DependencyElement& e : d.dependencies)
    for (Json& source : sources(e)) tables.push_back(std::move(source));
  for (const std::filesystem::path& place : d.program_places) programs.push_back(place.string());
  out["Tables"] = std::move(tables);
  out["Programs"] = std::move(programs);
  out["Services"] = describe_services(linked);
  out["Lacks"] = lacking(linked, library);
  return out;
}

}  // namespace isogloss::cli
