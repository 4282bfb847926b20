// The cases of pages: documentation that runs.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <span>

#include "case/case_report.hpp"
#include "isogloss/engine/cases.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "sandbox/untrusted.hpp"
#include "surroundings.hpp"

namespace isogloss::cli {

namespace {

struct CaseCommand {
  CommonOptions common;
  SurroundingOptions around;
  std::vector<std::string> files;
  std::string format = "text";
  bool all = false, verbose = false;

  int run() const;
};

/// Runs pages and keeps what came out.
class Cases {
 public:
  Cases(Session& session, const Surroundings& around, CaseDetail detail)
      : session_(session), around_(around), detail_(detail) {}

  void run_page(const std::string& text, const std::string& file) {
    CopyingSink diagnostics(session_.diagnostics());
    const Page page = read_page(text, file, diagnostics);
    CasePage out{file, page.syntax, {}, {}};
    // The page of a dependency need not hold one.
    const bool needs_none = session_.library().dependency(page.syntax) != nullptr;
    if (page.cases.empty() && !needs_none && diagnostics.copies.empty())
      diagnostics.add(host_diagnostic("IG-0501", {file}, {"the page holds no case"}));
    out.faults = std::move(diagnostics.copies);
    for (const Case& one : page.cases) {
      const auto begin = std::chrono::steady_clock::now();
      std::string difference = run_case(page, one, file, around_, session_.library(), detail_);
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
      if (!difference.empty()) session_.report("IG-0505", {file, one.line, 0}, {one.heading, page.syntax});
      out.cases.push_back({one.heading, one.line, std::move(difference), time.count()});
    }
    pages_.push_back(std::move(out));
  }

  const std::vector<CasePage>& pages() const { return pages_; }

 private:
  Session& session_;
  const Surroundings& around_;
  const CaseDetail detail_;
  std::vector<CasePage> pages_;
};

/// The pages that the plugins hold, by name.
std::vector<std::pair<std::string, const char*>> pages_of(const Library& library) {
  std::vector<std::pair<std::string, const char*>> out;
  const auto add = [&](const char* plugin, const char* id, const char* page, const char* cases) {
    const std::string name = fmt::format("{}:{}", plugin, id);
    if (page != nullptr) out.emplace_back(name, page);
    if (cases != nullptr) out.emplace_back(name + ".cases", cases);
  };
  for (const LoadedPlugin& loaded : library.plugins())
    for (const ig_syntax* syntax : std::span(loaded.plugin->syntaxes, loaded.plugin->syntax_count))
      add(loaded.plugin->name, syntax->id, syntax->page, syntax->cases);
  for (const LoadedPlugin& loaded : library.plugins())
    for (const ig_importer* importer : std::span(loaded.plugin->importers, loaded.plugin->importer_count))
      add(loaded.plugin->name, importer->id, importer->page, importer->cases);
  return out;
}

/// Adds after each page its file of further cases, x_syntax.cases.md, unless the user named that file too.
std::vector<std::string> with_other_cases(const std::vector<std::string>& files) {
  constexpr std::string_view ending = ".md", cases = ".cases.md";
  std::vector<std::string> out;
  for (const std::string& file : files) {
    out.push_back(file);
    if (!file.ends_with(ending) || file.ends_with(cases)) continue;
    std::string others = file.substr(0, file.size() - ending.size()).append(cases);
    std::error_code code;
    if (std::filesystem::is_regular_file(others, code) && std::find(files.begin(), files.end(), others) == files.end())
      out.push_back(std::move(others));
  }
  return out;
}

int CaseCommand::run() const {
  Session session(common);
  if (files.empty() && !all) {
    session.report("IG-0513", {}, {"name pages, or --all for those in the plugins"});
    return cannot_start;
  }
  std::vector<std::string> inputs = with_other_cases(files);
  inputs.insert(inputs.end(), {around.dialect, around.machine});
  if (!are_apart(inputs, {common.diagnostics_output}, session)) return cannot_start;
  const std::optional<Surroundings> surroundings = around.make(session);
  if (!surroundings) return cannot_start;
  Cases cases(session, *surroundings, verbose ? CaseDetail::whole : CaseDetail::first_paths);
  int status = success;
  const std::vector<std::string> named = with_other_cases(files);
  const auto held = all ? pages_of(session.library()) : std::vector<std::pair<std::string, const char*>>();
  std::size_t done = 0;
  const auto show = [&](const std::string& name) { session.progress().show(done++, named.size() + held.size(), name); };
  for (const std::string& file : named) {
    show(file);
    std::string error;
    if (const std::optional<std::string> text = read_text(file, error)) {
      cases.run_page(*text, file);
    } else {
      session.report("IG-0510", {file}, {error});
      status = cannot_start;
    }
  }
  for (const auto& [name, page] : held) {
    show(name);
    cases.run_page(page, name);
  }
  session.progress().hide();
  return print(format == "json"    ? cases_as_json(cases.pages())
               : format == "junit" ? cases_as_junit(cases.pages())
                                   : cases_as_text(cases.pages()),
               std::max(status, session.status()));
}

}  // namespace

int case_command(const Arguments& arguments) {
  CommandLine line(
      "case",
      "Runs the cases of pages: one build of the syntax must turn BeforeBuild into AfterBuild. The cases of "
      "x_syntax.cases.md belong to the page x_syntax.md and run with it.",
      "isogloss case plugins/iso/motion/dwell_syntax.md\n  isogloss case --all --format junit > cases.xml");
  CaseCommand command;
  line.option("FILE", command.files, "Pages (Markdown); - is standard input");
  line.flag("--all", command.all, "All pages in the plugins");
  line.flag(
      "--verbose", command.verbose,
      "Show every path that differs and the whole document of a case that does not hold, not the first paths alone");
  line.option("--format", command.format, "Form of the result")
      .one_of({"text", "json", "junit"})
      .type_name("text|json|junit")
      .shows_default();
  line.flag_for("--format", command.format, "json", "--json");
  line.flag_for("--format", command.format, "junit", "--junit");
  command.around.add_to(line);
  UntrustedOptions untrusted;
  untrusted.add_to(line);
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  UntrustedWork work = untrusted_work(command.common, command.around.dialect, command.around.machine);
  work.programs = command.files;
  if (const auto done = enter_untrusted(untrusted, work)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
