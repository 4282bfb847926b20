// What a machine has, and what it lacks for its dialect.
#include <fmt/format.h>

#include <algorithm>
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

bool is_provided(const ig_dependency& d, std::string_view service) {
  bool out = false;
  for (const char* const* id = d.provides; id != nullptr && *id != nullptr; ++id) out = out || *id == service;
  return out;
}

/// The rows of the table that names the axes, cell by cell: names, positions and travel. A later row goes over an
/// earlier one of the same axis.
Json axes(const LinkedDialect& linked) {
  Json out = Json::array();
  for (const Provision& p : provisions(linked)) {
    if (p.service != "isogloss.machine-axis/1") continue;
    const LinkedDependency& d = linked.dependencies[p.dependencies[0]];
    if (!is_provided(*d.dependency, "isogloss.axis-name/1")) continue;  // parameters of a control answer
    const std::string key = d.dependency->row_key != nullptr ? d.dependency->row_key : "";
    for (const TableRow& row : d.element.rows) {
      const auto name =
          std::find_if(row.attributes.begin(), row.attributes.end(), [&](const Attribute& a) { return a.name == key; });
      if (name == row.attributes.end()) continue;
      auto shown = std::find_if(out.begin(), out.end(), [&](const Json& axis) { return axis["Axis"] == name->value; });
      if (shown == out.end()) shown = out.insert(out.end(), Json{{"Axis", name->value}});
      for (const Attribute& a : row.attributes)
        if (a.name != key) (*shown)[a.name] = a.value;
    }
  }
  return out;
}

/// Services that syntaxes ask for, that no table of the machine answers and that some dependency could.
Json lacking(const LinkedDialect& linked, const Library& library) {
  std::set<std::string, std::less<>> answered;
  for (const Provision& p : provisions(linked)) answered.insert(p.service);
  struct Asked {
    bool is_optional = true;
    std::string purpose;
    Json syntaxes = Json::array(), offered = Json::array();
  };
  std::map<std::string, Asked, std::less<>> asked;
  for (const LinkedSyntax& s : linked.chain)
    for (std::uint32_t i = 0; i < s.syntax->service_count; ++i) {
      const ig_service_decl& service = s.syntax->services[i];
      if (answered.contains(service.id)) continue;
      Asked& a = asked[service.id];
      a.is_optional = a.is_optional && service.is_optional != 0;
      if (a.purpose.empty() && service.doc != nullptr) a.purpose = service.doc;
      a.syntaxes.push_back(s.element.alias);
    }
  for (const LoadedPlugin& p : library.plugins())
    for (std::uint32_t i = 0; i < p.plugin->dependency_count; ++i) {
      const ig_dependency& d = *p.plugin->dependencies[i];
      for (const char* const* id = d.provides; id != nullptr && *id != nullptr; ++id)
        if (const auto a = asked.find(*id); a != asked.end()) a->second.offered.push_back(d.id);
    }
  Json out = Json::array();
  for (auto& [service, a] : asked)
    if (!a.offered.empty())
      out.push_back({{"Service", service},
                     {"Need", a.is_optional ? "optional" : "required"},
                     {"For", a.purpose},
                     {"Asked by", std::move(a.syntaxes)},
                     {"Offered by", std::move(a.offered)}});
  return out;
}

/// By code: how often, and where first.
Json not_answered(const std::vector<Diagnostic>& diagnostics) {
  Json out = Json::array();
  std::map<std::string, std::size_t, std::less<>> known;
  for (const Diagnostic& d : diagnostics) {
    if (d.severity == Severity::note) continue;
    const auto [place, is_new] = known.emplace(d.code, out.size());
    if (is_new)
      out.push_back({{"Code", d.code},
                     {"Severity", to_string(d.severity)},
                     {"Count", 0},
                     {"First", fmt::format("{}:{}", d.where.file, d.where.line)},
                     {"Text", d.message}});
    Json& count = out[place->second]["Count"];
    count = count.get<std::size_t>() + 1;
  }
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
  out["Axes"] = axes(linked);
  out["Programs"] = std::move(programs);
  out["Services"] = describe_services(linked);
  out["Lacks"] = lacking(linked, library);
  return out;
}

Json describe_needs(const std::string& program, const Dialect& machine, const ProgramNeeds& needs,
                    const std::vector<Diagnostic>& diagnostics) {
  const std::string folder = (machine.file.parent_path() / "").string();
  const auto shown = [&](const std::string& file) {
    return file.starts_with(folder) ? file.substr(folder.size()) : file;
  };
  Json rows = Json::array(), programs = Json::array();
  for (const NeededRow& r : needs.rows) {
    Json row{{"Table", r.dependency}, {"Row", r.row}};
    if (!r.where.file.empty())
      row["Answers"] = fmt::format("{}:{}", shown(r.where.file), r.where.line);
    else
      row["Answers"] = r.is_there ? "the table as it is delivered" : "no row: a default, or a diagnostic below";
    rows.push_back(std::move(row));
  }
  for (const NeededProgram& p : needs.programs) programs.push_back({{"Program", p.name}, {"File", shown(p.file)}});
  return {{"Program", program},
          {"Rows", std::move(rows)},
          {"Programs called", std::move(programs)},
          {"Not answered", not_answered(diagnostics)}};
}

}  // namespace isogloss::cli
