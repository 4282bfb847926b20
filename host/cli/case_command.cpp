// The cases of pages: documentation that runs.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "isogloss/engine/cases.hpp"
#include "output_file.hpp"
#include "surroundings.hpp"

namespace isogloss::cli {

namespace {

struct CaseCommand {
  CommonOptions common;
  SurroundingOptions around;
  std::vector<std::string> files;
  bool all = false;

  int run() const;
};

/// Runs pages and counts.
class Cases {
 public:
  Cases(Session& session, const Surroundings& around) : session_(session), around_(around) {}

  void run_page(const std::string& text, const std::string& file) {
    const Page page = read_page(text, file, session_.diagnostics());
    ++pages_;
    // The page of a dependency need not hold one.
    const bool needs_none = session_.library().dependency(page.syntax) != nullptr;
    if (page.cases.empty() && !needs_none && session_.diagnostics().errors() == 0)
      session_.report("IG-0501", {file}, {"the page holds no case"});
    for (const Case& one : page.cases) {
      const std::string difference = run_case(page, one, file, around_, session_.library());
      if (difference.empty()) {
        ++held_;
        continue;
      }
      ++failed_;
      session_.report("IG-0505", {file, one.line, 0}, {one.heading, page.syntax});
      report_ += fmt::format("{}:{}: {}\n{}\n", file, one.line, one.heading, difference);
    }
  }

  std::string report() const {
    return report_ + fmt::format("{} cases of {} pages: {} hold, {} fail\n", held_ + failed_, pages_, held_, failed_);
  }

 private:
  Session& session_;
  const Surroundings& around_;
  std::size_t pages_ = 0, held_ = 0, failed_ = 0;
  std::string report_;
};

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
  const std::optional<Surroundings> surroundings = around.make(session);
  if (!surroundings) return cannot_start;
  Cases cases(session, *surroundings);
  int status = success;
  for (const std::string& file : with_other_cases(files)) {
    std::string error;
    if (const std::optional<std::string> text = read_text(file, error)) {
      cases.run_page(*text, file);
    } else {
      session.report("IG-0510", {file}, {error});
      status = cannot_start;
    }
  }
  if (all)
    for (const LoadedPlugin& loaded : session.library().plugins())
      for (std::uint32_t i = 0; i < loaded.plugin->syntax_count; ++i) {
        const ig_syntax& syntax = *loaded.plugin->syntaxes[i];
        const std::string name = fmt::format("{}:{}", loaded.plugin->name, syntax.id);
        if (syntax.page != nullptr) cases.run_page(syntax.page, name);
        if (syntax.cases != nullptr) cases.run_page(syntax.cases, name + ".cases");
      }
  if (all)
    for (const LoadedPlugin& loaded : session.library().plugins())
      for (std::uint32_t i = 0; i < loaded.plugin->importer_count; ++i) {
        const ig_importer& importer = *loaded.plugin->importers[i];
        const std::string name = fmt::format("{}:{}", loaded.plugin->name, importer.id);
        if (importer.page != nullptr) cases.run_page(importer.page, name);
        if (importer.cases != nullptr) cases.run_page(importer.cases, name + ".cases");
      }
  return print(cases.report(), std::max(status, session.status()));
}

}  // namespace

int case_command(const Arguments& arguments) {
  CommandLine line(
      "case",
      "Runs the cases of pages: one build of the syntax must turn BeforeBuild into AfterBuild. The cases of "
      "x_syntax.cases.md belong to the page x_syntax.md and run with it.",
      "isogloss case plugins/iso/motion/dwell_syntax.md");
  CaseCommand command;
  line.option("FILE", command.files, "Pages (Markdown); - is standard input");
  line.flag("--all", command.all, "All pages in the plugins");
  command.around.add_to(line);
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
