// Reports what was found where, and what was not loaded and why.
#include <fmt/format.h>
#include <unistd.h>

#include "json_text.hpp"
#include "output_file.hpp"
#include "sandbox/untrusted.hpp"
#include "session.hpp"

namespace isogloss::cli {

namespace {

struct DoctorCommand {
  CommonOptions common;
  bool json = false;

  int run() const;
};

Json describe_places(const std::vector<Place>& places) {
  Json out = Json::array();
  std::error_code ignored;
  for (const Place& p : places)
    out.push_back({{"Folder", p.folder.string()},
                   {"NamedBy", p.named_by},
                   {"Exists", std::filesystem::is_directory(p.folder, ignored)}});
  return out;
}

/// Plugins that work but break a recommendation.
Json describe_warnings(const Library& library) {
  Json out = Json::array();
  for (const Diagnostic& d : library.shared_codes()) out.push_back({{"Code", d.code}, {"Message", d.message}});
  for (const LoadedPlugin& p : library.plugins()) {
    if (p.extra_exports.empty()) continue;
    const Diagnostic d = host_diagnostic(
        "IG-0309", {}, {p.file.string(), std::to_string(p.extra_exports.size()), p.extra_exports.front()});
    out.push_back({{"File", p.file.string()}, {"Code", d.code}, {"Message", d.message}});
  }
  return out;
}

/// A dialect or machine with the reason why it does not link.
Json describe_linking(const std::string& name, const std::string& source, Session& session) {
  DiagnosticList said;
  if (const std::optional<Dialect> dialect = session.read(source, said)) link(*dialect, session.library(), said);
  Json faults = Json::array(), warnings = Json::array();
  for (const Diagnostic& d : said.all)
    if (d.severity != Severity::note)
      (d.severity == Severity::error ? faults : warnings)
          .push_back(fmt::format("{}:{}:{}: {} [{}]", d.where.file, d.where.line, d.where.column, d.message, d.code));
  return {{"Name", name}, {"File", source}, {"Faults", std::move(faults)}, {"Warnings", std::move(warnings)}};
}

/// Of several dialects with one name the first found is used.
Json describe_dialects(Session& session) {
  Json out = Json::array();
  const std::vector<Dialect> all = session.reader().list();
  for (const Dialect& d : all) {
    session.progress().show(out.size(), all.size(), "dialect " + d.name);
    out.push_back(describe_linking(d.name, d.file.empty() ? d.name : d.file.string(), session));
  }
  return out;
}

Json describe_machines(Session& session) {
  Json out = Json::array();
  const std::vector<FoundMachine> all = session.machines();
  for (const FoundMachine& m : all) {
    session.progress().show(out.size(), all.size(), "machine " + m.name);
    if (!m.is_tables) out.push_back(describe_linking(m.name, m.file.string(), session));
  }
  return out;
}

std::string as_text(const Json& all) {
  std::string out;
  const auto places = [&](const char* title, const char* key) {
    out += fmt::format("{}\n", title);
    for (const Json& p : all[key])
      out += fmt::format("  {} ({}{})\n", p["Folder"].get<std::string>(), p["NamedBy"].get<std::string>(),
                         p["Exists"].get<bool>() ? "" : ", does not exist");
  };
  places("Plugin folders, in order", "PluginFolders");
  out += "Plugins\n";
  for (const Json& p : all["Plugins"])
    out += fmt::format("  {} {}: {} syntaxes, {} dependencies, {} importers, {}\n", p["Name"].get<std::string>(),
                       p["Version"].get<std::string>(), p["Syntaxes"].get<int>(), p["Dependencies"].get<int>(),
                       p["Importers"].get<int>(), p["File"].get<std::string>());
  if (!all["Warnings"].empty()) out += "Warnings\n";
  for (const Json& w : all["Warnings"])
    out += fmt::format("  {} [{}]\n", w["Message"].get<std::string>(), w["Code"].get<std::string>());
  if (!all["Refused"].empty()) out += "Not loaded\n";
  for (const Json& r : all["Refused"])
    out += fmt::format("  {} [{}]\n", r["Reason"].get<std::string>(), r["Code"].get<std::string>());
  const auto linking = [&](const char* title, const char* key) {
    out += fmt::format("{}\n", title);
    for (const Json& d : all[key]) {
      out += fmt::format("  {}: {}, {}\n", d["Name"].get<std::string>(), d["File"].get<std::string>(),
                         d["Faults"].empty() ? "links" : "does not link:");
      for (const Json& fault : d["Faults"]) out += fmt::format("    {}\n", fault.get<std::string>());
      for (const Json& warning : d["Warnings"]) out += fmt::format("    warning: {}\n", warning.get<std::string>());
    }
  };
  places("Dialect folders, in order", "DialectFolders");
  linking("Dialects", "Dialects");
  places("Machine folders, in order", "MachineFolders");
  if (!all["Machines"].empty()) linking("Machines", "Machines");
  return out;
}

int DoctorCommand::run() const {
  Session session(common);
  session.library().load_all();
  Json all{{"Host", ISOGLOSS_VERSION}, {"Contract", fmt::format("{}.{}", IG_ABI_MAJOR, IG_ABI_MINOR)}};
  all["PluginFolders"] = describe_places(session.plugin_places());
  Json& plugins = all["Plugins"] = Json::array();
  for (const LoadedPlugin& p : session.library().plugins())
    plugins.push_back({{"Name", p.plugin->name},
                       {"Version", p.plugin->version == nullptr ? "" : p.plugin->version},
                       {"Syntaxes", p.plugin->syntax_count},
                       {"Dependencies", p.plugin->dependency_count},
                       {"Importers", p.plugin->importer_count},
                       {"File", p.file.string()}});
  all["Warnings"] = describe_warnings(session.library());
  Json& refused = all["Refused"] = Json::array();
  for (const RefusedPlugin& r : session.library().refused())
    refused.push_back({{"File", r.file.string()}, {"Code", r.code}, {"Reason", r.reason}});
  all["DialectFolders"] = describe_places(session.dialect_places());
  all["Dialects"] = describe_dialects(session);
  all["MachineFolders"] = describe_places(session.machine_places());
  all["Machines"] = describe_machines(session);
  bool is_well = all["Refused"].empty();
  std::size_t warnings = all["Warnings"].size();
  for (const char* const key : {"Dialects", "Machines"})
    for (const Json& d : all[key]) {
      is_well = is_well && d["Faults"].empty();
      warnings += d["Warnings"].size();
    }
  const std::string verdict = !is_well        ? "Something was not loaded.\n"
                              : warnings == 0 ? "All is well.\n"
                                              : fmt::format("All is loaded; warnings: {}.\n", warnings);
  const std::string out = json ? pretty(all) : fitted(as_text(all) + verdict, columns_of(STDOUT_FILENO));
  session.progress().hide();
  return print(out, is_well ? success : input_errors);
}

}  // namespace

int doctor_command(const Arguments& arguments) {
  CommandLine line("doctor", "Reports which folders are searched, what was found, and what was not loaded and why.",
                   "isogloss doctor --plugins ./build/plugins");
  DoctorCommand command;
  line.flag("--json", command.json, "Write JSON");
  UntrustedOptions untrusted;
  untrusted.add_to(line);
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  UntrustedWork work = untrusted_work(command.common, "", "");
  if (const auto done = enter_untrusted(untrusted, work)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
