// The page and the declaration of one syntax, dependency, dialect or field.
#include <fmt/format.h>
#include <unistd.h>

#include "crash_guard.hpp"
#include "json_text.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "page_section.hpp"
#include "program_options.hpp"
#include "sandbox/untrusted.hpp"

namespace isogloss::cli {

namespace {

struct InspectCommand {
  CommonOptions common;
  std::string name, dialect, machine, section;
  std::vector<std::string> programs;
  bool json = false;

  int run() const;
  std::optional<FoundMachine> find_machine(Session& session) const;
  int show_machine(const FoundMachine& found, Session& session) const;
  int show(Json declaration, const char* page, Session& session) const;
  void report_idle_dialect(const char* kind, Session& session) const;
  int show_section(const std::vector<std::string>& pages, Session& session) const;
  std::optional<int> show_code(const LinkedDialect& linked, Session& session) const;
  std::vector<std::string> names(Session& session, const Json& fields) const;
  std::string near_code(const LinkedDialect& linked) const;
};

/// Of the pages alone: JSON is the text with its name and title.
int InspectCommand::show_section(const std::vector<std::string>& pages, Session& session) const {
  std::string found;
  std::vector<std::string> titles;
  for (const std::string& page : pages) {
    for (std::string& title : headings(page)) titles.push_back(std::move(title));
    if (const std::optional<std::string> part = section_of(page, section)) found += (found.empty() ? "" : "\n") + *part;
  }
  if (found.empty()) {
    std::string near = nearest_name(section, titles);
    for (const std::string& title : titles)
      if (near.empty() && title.starts_with(section)) near = title;
    session.report("IG-0174", {}, {name, section},
                   !near.empty()     ? "did you mean " + near + "?"
                   : !titles.empty() ? fmt::format("its sections are {}", fmt::join(titles, ", "))
                                     : "it has no page");
    return input_errors;
  }
  const Json out{{"Name", name}, {"Section", section}, {"Page", found}};
  return print(json ? pretty(out) : found, session.status());
}

/// "g1" -> "G01", as dialects write the codes of one digit.
std::string canonical_code(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  if (text.size() == 2 && text[1] >= '0' && text[1] <= '9') text.insert(1, "0");
  return text;
}

/// The syntaxes that take this code or word in the dialect, in the order of the chain, with their pages. Empty when
/// none does.
std::optional<int> InspectCommand::show_code(const LinkedDialect& linked, Session& session) const {
  Json rows = Json::array();
  for (Json& row : describe_codes(linked))
    if (row["Code"] == name || row["Code"] == canonical_code(name)) rows.push_back(std::move(row));
  if (rows.empty()) return std::nullopt;
  std::string text, all;
  std::vector<std::string> pages;
  for (Json& row : rows) {
    const LinkedSyntax& s = linked.chain[*linked.position(row["Syntax"].get<std::string>())];
    std::string page = printable_page(s.syntax->page);
    text += fmt::format("{} in {}: {} ({}), {}:{}\n", row["Code"].get<std::string>(), linked.dialect.name,
                        s.element.alias, row["Page"].get<std::string>(), s.element.where.file, s.element.where.line);
    all += page;
    row["PageFile"] = row["Page"];
    row["Page"] = page;
    pages.push_back(std::move(page));
    row["Link"] = describe_link(s, linked.layout);
  }
  if (!section.empty()) return show_section(pages, session);
  const Json out{{"Code", rows[0]["Code"]}, {"Dialect", linked.dialect.name}, {"Syntaxes", std::move(rows)}};
  return print(json ? pretty(out) : text + "\n" + all, session.status());
}

int InspectCommand::show(Json declaration, const char* page, Session& session) const {
  if (!section.empty()) return show_section({printable_page(page)}, session);
  if (json) {
    if (page != nullptr) declaration["Page"] = printable_page(page);
    return print(pretty(declaration), session.status());
  }
  declaration.erase("HasPage");
  std::string out = printable_page(page);
  if (!out.empty() && !out.ends_with('\n')) out += '\n';
  if (!out.empty()) out += "\n---- declaration\n";
  return print(out + fitted(as_lines(declaration), columns_of(STDOUT_FILENO)), session.status());
}

/// Of -d and -m, where what is shown is the same in every dialect.
void InspectCommand::report_idle_dialect(const char* kind, Session& session) const {
  if (dialect.empty() && machine.empty()) return;
  session.report("IG-0519", {}, {dialect.empty() ? "--machine" : "--dialect", name + " is " + kind});
}

std::optional<FoundMachine> InspectCommand::find_machine(Session& session) const {
  std::error_code code;
  const std::filesystem::path path(name);
  if (path.filename() == "machine.xml" || std::filesystem::exists(path / "machine.xml", code))
    return session.find_machine(name);
  for (FoundMachine& m : session.machines())
    if (m.name == name) return std::move(m);
  return std::nullopt;
}

int InspectCommand::show_machine(const FoundMachine& found, Session& session) const {
  if (found.is_tables) return show(describe(found), nullptr, session);
  const auto whole = session.link(found.file.string());
  if (whole == nullptr) return input_errors;
  Json out = describe_machine(*whole, session.library());
  bool has_errors = false;
  for (const std::string& program : programs) {
    ProgramOptions run;
    run.machine = found.file.string();
    std::optional<RunOptions> options = run.make(session);
    const std::unique_ptr<OpenedProgram> source = OpenedProgram::open(program, session);
    if (!options || source == nullptr) return cannot_start;
    add_program_places(program, whole->dialect, *options);
    watch_calls(run.watchdog);
    DiagnosticList reported;
    options->progress = [&](std::uint64_t blocks, std::uint64_t) {
      session.progress().show(0, 0, fmt::format("{}: {} blocks", program, blocks));
    };
    const ProgramNeeds needs = find_needs(*whole, *source, program, *options, reported);
    has_errors = has_errors || reported.has_errors();
    out["Needs"].push_back(describe_needs(program, whole->dialect, needs, reported.all));
  }
  session.progress().hide();
  const int shown = show(std::move(out), nullptr, session);
  return shown == success && has_errors ? static_cast<int>(input_errors) : shown;
}

std::vector<std::string> InspectCommand::names(Session& session, const Json& fields) const {
  std::vector<std::string> out;
  for (const LoadedPlugin& p : session.library().plugins()) {
    for (std::uint32_t i = 0; i < p.plugin->syntax_count; ++i) out.emplace_back(p.plugin->syntaxes[i]->id);
    for (std::uint32_t i = 0; i < p.plugin->dependency_count; ++i) out.emplace_back(p.plugin->dependencies[i]->id);
    for (std::uint32_t i = 0; i < p.plugin->importer_count; ++i) out.emplace_back(p.plugin->importers[i]->id);
  }
  for (const Dialect& d : session.reader().list()) out.push_back(d.name);
  for (const FoundMachine& m : session.machines()) out.push_back(m.name);
  for (const Json& f : fields) out.push_back(f["Path"].get<std::string>());
  return out;
}

std::string InspectCommand::near_code(const LinkedDialect& linked) const {
  std::vector<std::string> codes;
  for (const Json& row : describe_codes(linked)) codes.push_back(row["Code"].get<std::string>());
  const std::string near = nearest_name(name, codes);
  return (near.empty() ? "" : "did you mean " + near + "? ") + "isogloss list codes -d " + linked.dialect.name +
         " lists what it answers";
}

int InspectCommand::run() const {
  Session session(common);
  std::vector<std::string> inputs = programs;
  inputs.insert(inputs.end(), {name, dialect, machine});
  if (!are_apart(inputs, {common.diagnostics_output}, session)) return cannot_start;
  session.library().load_all();
  const std::optional<FoundMachine> found = find_machine(session);
  if (!programs.empty() && (!found || found->is_tables)) {
    session.report("IG-0513", {}, {"--for needs a machine, and '" + name + "' is none with a dialect"},
                   "isogloss list machines names them");
    return cannot_start;
  }
  const ig_plugin* plugin = nullptr;
  std::unique_ptr<LinkedDialect> linked;
  const std::optional<std::string> named = session.dialect_or_machine(dialect, machine);
  if (!named) return cannot_start;
  if (!named->empty()) {
    linked = session.link(*named);
    if (linked == nullptr) return cannot_start;
  }
  if (const ig_syntax* const syntax = session.library().syntax(name, &plugin)) {
    Json out = describe(*syntax, *plugin);
    if (linked != nullptr) {
      Json& links = out["In " + linked->dialect.name] = Json::array();
      for (const LinkedSyntax& s : linked->chain)
        if (s.syntax == syntax) links.push_back(describe_link(s, linked->layout));
    }
    return show(std::move(out), syntax->page, session);
  }
  if (const ig_dependency* const dependency = session.library().dependency(name, &plugin)) {
    Json out = describe(*dependency, *plugin);
    if (linked != nullptr) {
      const Json described = describe(linked->dialect);
      for (const Json& d : described["Dependencies"])
        if (d["Id"] == name) out["In " + linked->dialect.name] = d;
    }
    return show(std::move(out), dependency->page, session);
  }
  if (const ig_importer* const importer = session.library().importer(name, &plugin)) {
    report_idle_dialect("an importer", session);
    return show(describe(*importer, *plugin), importer->page, session);
  }
  if (found) {
    report_idle_dialect("a machine itself", session);
    return show_machine(*found, session);
  }
  const std::vector<Dialect> dialects = session.reader().list();
  const bool is_dialect =
      name.find('/') != std::string::npos || name.ends_with(".xml") ||
      std::any_of(dialects.begin(), dialects.end(), [&](const Dialect& d) { return d.name == name; });
  if (is_dialect) {
    report_idle_dialect("a dialect itself", session);
    const std::optional<Dialect> read = session.read(name);
    if (!read) return input_errors;
    Json out = describe(*read);
    DiagnosticList unheard;  // `lint` reports what keeps it from linking
    if (const auto whole = link(*read, session.library(), unheard)) out["Services"] = describe_services(*whole);
    return show(std::move(out), nullptr, session);
  }
  if (linked != nullptr)
    if (const std::optional<int> done = show_code(*linked, session)) return *done;
  const Json fields = describe_fields(session.library());
  for (const Json& f : fields)
    if (f["Path"] == name) {
      report_idle_dialect("a field, the same in every dialect", session);
      return show(f, nullptr, session);
    }
  const std::string near = nearest_name(name, names(session, fields));
  const std::string hint = near.empty() ? "" : "did you mean " + near + "?";
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool is_code = name.size() > 1 && name.size() < 8 && is_digit(name[1]) && !is_digit(name[0]);
  if (is_code && linked != nullptr)
    session.report("IG-0173", {}, {linked->dialect.name, name}, near_code(*linked));
  else
    session.report("IG-0516", {}, {name}, is_code ? "for a code of programs, name the dialect: -d fanuc" : hint);
  return cannot_start;
}

}  // namespace

int inspect_command(const Arguments& arguments) {
  CommandLine line("inspect", "Shows the page and the declaration of a syntax, dependency, dialect, machine or field.",
                   "isogloss inspect DrillingCycleSyntax -d fanuc\n  isogloss inspect G83 -d fanuc\n  "
                   "isogloss inspect DwellSyntax --section Diagnostics\n  isogloss inspect dmu85 --for part.h");
  InspectCommand command;
  line.option("NAME", command.name,
              "Id of a syntax or dependency, name or file of a dialect or machine, path of a field; with -d or -m, a "
              "code or word of programs, too")
      .required();
  line.option("-d,--dialect", command.dialect, "Show the options and resolved patterns of this dialect too")
      .type_name("DIALECT");
  line.option("-m,--machine", command.machine, "Show those of this machine").type_name("MACHINE");
  line.option("--for", command.programs,
              "Of a machine: run this program, and show which of its needs the machine answers (repeatable)")
      .type_name("PROGRAM");
  line.option("--section", command.section, "Print the section of the page that has this heading, alone")
      .type_name("HEADING");
  line.flag("--json", command.json, "Write JSON");
  UntrustedOptions untrusted;
  untrusted.add_to(line);
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  UntrustedWork work = untrusted_work(command.common, command.dialect, command.machine);
  work.programs = command.programs;
  work.reads.push_back(command.name);
  if (const auto done = enter_untrusted(untrusted, work)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
