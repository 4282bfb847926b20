// Writes the reference of all plugins and dialects that are installed, as linked pages.
#include <filesystem>

#include "docs/docs_folder.hpp"
#include "docs/site.hpp"
#include "json_text.hpp"
#include "new/folder.hpp"
#include "output_file.hpp"

namespace isogloss::cli {

namespace {

struct DocsCommand {
  CommonOptions common;
  std::string folder, format = "html";
  bool json = false;

  int run() const {
    using namespace docs;
    Session session(common);
    const DocsFolder target(folder);
    if (!target.is_ours(session)) return cannot_start;
    const Reference reference = collect(session);
    const bool is_html = format == "html";
    Site site(reference, is_html ? Format::html : Format::markdown);
    for (const auto write : {write_parts, write_dialects, write_machines, write_plugins, write_fields,
                             write_diagnostics, write_codes, write_index})
      write(site);
    if (is_html) {
      write_names(site);
      for (auto& [name, text] : read_templates("docs", session)) site.add_file(name, std::move(text));
      if (!site.files().contains("style.css")) return cannot_start;
    }
    for (const DeadLink& dead : site.dead_links()) session.report("IG-0176", {}, {dead.part, dead.link});
    if (!target.write(site.files(), session)) return cannot_start;
    const std::string first = is_html ? "index.html" : "index.md";
    if (json) {
      Json files = Json::array();
      for (const auto& [name, text] : site.files()) files.push_back(name);
      return print(
          pretty(
              {{"Isogloss", 1}, {"Folder", folder}, {"Format", format}, {"First", first}, {"Files", std::move(files)}}),
          session.status());
    }
    return print((std::filesystem::path(folder) / first).string() + "\n", session.status());
  }
};

}  // namespace

int docs_command(const Arguments& arguments) {
  CommandLine line(
      "docs",
      "Writes the reference of all installed plugins, dialects and machines into a folder, and prints the path of "
      "its first page.\n\nThe pages hold syntaxes with their options and cases, tables, importers, fields "
      "with who writes and reads them,\ndiagnostics, codes by dialect, chains as graphs, and the tables of machines "
      "with the source of each row. They open "
      "from disk. An empty folder, or one of an earlier\nreference, is filled; any other is refused. Exit "
      "status: 0 when the reference is written, 1 when a dialect or machine does not\nlink (its page says so), 2 "
      "when nothing could be written.",
      "isogloss docs -o reference\n  isogloss docs -o reference --plugins ./build --dialects . "
      "--format markdown");
  DocsCommand command;
  line.option("-o,--output", command.folder, "The folder of the reference").type_name("DIR").required();
  line.option("--format", command.format, "Form of the pages")
      .one_of({"html", "markdown"})
      .type_name("html|markdown")
      .shows_default();
  line.flag("--json", command.json, "Write JSON (schemas/docs.schema.json) about the folder and its files");
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
