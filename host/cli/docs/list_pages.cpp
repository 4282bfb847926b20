// Pages that list: plugins, fields, codes, and the first page.
#include <fmt/format.h>

#include <algorithm>

#include "docs/site.hpp"

namespace isogloss::cli::docs {

namespace {

std::vector<std::string> parts_of(const Site& site, PartKind kind, const std::string& plugin) {
  std::vector<std::string> out;
  for (const Part& part : site.reference().parts)
    if (part.kind == kind && part.plugin == plugin) out.push_back(part.id);
  return out;
}

void write_plugin(Site& site, const Json& plugin) {
  const std::string name = text_of(plugin, "Name");
  const auto page = site.page(site.addresses().find(Kind::plugin, name)->file, name);
  std::vector<Markup> facts;
  for (const auto& [key, label] : {std::pair("Version", "Version"), std::pair("Vendor", "Vendor"),
                                   std::pair("Contract", "Contract"), std::pair("BuiltWith", "Built with")})
    if (const std::string value = text_of(plugin, key); !value.empty())
      facts.push_back(fact(*page, label, page->text(value)));
  std::vector<std::string> used_by;
  for (const ShownDialect& d : site.reference().dialects)
    for (const std::string& one : texts(d.declaration["Plugins"]))
      if (one == name) used_by.push_back(d.name);
  if (!used_by.empty()) facts.push_back(fact(*page, "Dialects", page->names(Kind::dialect, used_by)));
  page->list(facts);

  const auto add_parts = [&](PartKind kind, const std::string& title) {
    std::vector<Row> rows;
    for (const Part& part : site.reference().parts)
      if (part.kind == kind && part.plugin == name)
        rows.push_back({{page->name(Kind::part, part.id), page->prose(text_of(part.declaration, "Summary"))}});
    if (!rows.empty()) page->heading(2, page->text(title), file_stem(title));
    page->table({"Name", "Summary"}, rows);
  };
  add_parts(PartKind::syntax, "Syntaxes");
  add_parts(PartKind::dependency, "Tables");
  add_parts(PartKind::importer, "Importers");

  std::vector<Row> rows;
  for (const Json& d : site.reference().diagnostics) {
    const std::string plugins = ", " + text_of(d, "Plugin") + ", ";
    if (plugins.find(", " + name + ", ") != std::string::npos)
      rows.push_back({{page->name(Kind::diagnostic, text_of(d, "Code")), page->text(text_of(d, "Severity")),
                       page->prose(text_of(d, "Text"))}});
  }
  if (!rows.empty()) page->heading(2, page->text("Diagnostics"), "diagnostics");
  page->table({"Code", "Severity", "Text"}, rows);
  site.add(*page);
}

Markup answers(const Page& page, const Code& code, std::size_t dialects) {
  Markup out;
  for (const CodeAnswer& answer : code.answers) {
    out += (out.empty() ? "" : page.line_break()) + page.name(Kind::part, answer.syntax) + page.text(": ");
    out += answer.dialects.size() == dialects && dialects > 1 ? page.text("all dialects")
                                                              : page.names(Kind::dialect, answer.dialects);
  }
  return out;
}

}  // namespace

void write_plugins(Site& site) {
  const auto page = site.page("plugins", "Plugins");
  std::vector<Row> rows;
  for (const Json& plugin : site.reference().plugins) {
    write_plugin(site, plugin);
    const std::string name = text_of(plugin, "Name");
    const auto count = [&](PartKind kind) { return page->text(fmt::format("{}", parts_of(site, kind, name).size())); };
    rows.push_back(
        {{page->name(Kind::plugin, name), page->text(text_of(plugin, "Version")), page->text(text_of(plugin, "Vendor")),
          count(PartKind::syntax), count(PartKind::dependency), count(PartKind::importer)}});
  }
  page->table({"Name", "Version", "Vendor", "Syntaxes", "Tables", "Importers"}, rows);
  site.add(*page);
}

void write_fields(Site& site) {
  std::map<std::string, std::vector<const Json*>> by_file;
  for (const Json& field : site.reference().fields)
    by_file[site.addresses().find(Kind::field, text_of(field, "Path"))->file].push_back(&field);
  const auto all = site.page("fields", "Fields");
  all->paragraph(all->text(
      "A block is a document of sections with fields. Parsing holds what was read and is not used up yet: words and "
      "codes."));
  std::vector<Row> sections;
  for (const auto& [file, fields] : by_file) {
    const std::string section = section_of_field(text_of(*fields.front(), "Path"));
    const auto page = site.page(file, section);
    std::vector<Row> rows;
    for (const Json* f : fields) {
      const std::string path = text_of(*f, "Path");
      const auto parts = [&](const char* key) { return page->names(Kind::part, texts((*f)[key])); };
      rows.push_back({{page->code(path), page->text(text_of(*f, "Type")), page->text(text_of(*f, "Unit")),
                       page->text(text_of(*f, "Life")), page->prose(text_of(*f, "Doc")), parts("Writers"),
                       parts("Readers"), parts("Takers")},
                      site.addresses().find(Kind::field, path)->anchor});
    }
    page->table({"Field", "Type", "Unit", "Life", "Meaning", "Written by", "Read by", "Used up by"}, rows);
    site.add(*page);
    sections.push_back({{all->link({file, {}}, all->code(section)), all->text(fmt::format("{}", fields.size()))}});
  }
  all->table({"Section", "Fields"}, sections);
  site.add(*all);
}

void write_codes(Site& site) {
  const auto page = site.page("codes", "Codes and words by dialect");
  page->paragraph(page->text(
      "Each code of programs with the syntaxes that answer it, and the dialects in which they do. A dialect's own page "
      "has its codes alone."));
  // Codes by their first letter, then all words.
  std::map<std::string, std::vector<Row>> groups;
  for (const auto& [name, code] : site.reference().codes) {
    Row row{{page->code(name), answers(*page, code, site.reference().dialects.size())},
            site.addresses().find(Kind::code, name)->anchor};
    groups[code.is_word ? "words" : name.substr(0, 1)].push_back(std::move(row));
  }
  const auto place = [](const std::string& group) { return file_stem(group) + "."; };
  Markup letters;
  for (const auto& [group, rows] : groups)
    letters += (letters.empty() ? "" : " ") + page->link({"codes", place(group)}, page->text(group));
  page->paragraph(letters);
  for (const auto& [group, rows] : groups) {
    page->heading(2, page->text(group), place(group));
    page->table({group == "words" ? "Word" : "Code", "Answered by"}, rows);
  }
  site.add(*page);
}

void write_index(Site& site) {
  const Reference& r = site.reference();
  const auto page = site.page("index", "Reference");
  page->paragraph(
      page->text("What the installed plugins, dialects and machines declare, with the pages of the plugins. A dialect "
                 "is a chain of "
                 "syntaxes; each syntax reads and writes fields of one block."));
  const auto entry = [&](const char* file, std::size_t count, const char* what) {
    return page->link({file, {}}, page->text(fmt::format("{} {}", count, what)));
  };
  const auto count = [&](PartKind kind) {
    return static_cast<std::size_t>(
        std::count_if(r.parts.begin(), r.parts.end(), [&](const Part& p) { return p.kind == kind; }));
  };
  page->list({entry("syntaxes", count(PartKind::syntax), "syntaxes"),
              entry("codes", r.codes.size(), "codes and words, by dialect"),
              entry("fields", r.fields.size(), "fields, with who writes and reads them"),
              entry("diagnostics", r.diagnostics.size(), "diagnostics"),
              entry("tables", count(PartKind::dependency), "tables and other dependencies"),
              entry("importers", count(PartKind::importer), "importers of files of controls")});
  page->heading(2, page->link({"dialects", {}}, page->text("Dialects")), "dialects");
  std::vector<Row> rows;
  for (const ShownDialect& d : r.dialects)
    rows.push_back({{page->name(Kind::dialect, d.name), page->prose(text_of(d.declaration, "Title"))}});
  page->table({"Name", "Title"}, rows);
  page->heading(2, page->link({"machines", {}}, page->text("Machines")), "machines");
  rows.clear();
  for (const ShownMachine& m : r.machines) rows.push_back({{page->name(Kind::machine, m.name), page->prose(m.title)}});
  page->table({"Name", "Title"}, rows);
  page->heading(2, page->link({"plugins", {}}, page->text("Plugins")), "plugins");
  rows.clear();
  for (const Json& p : r.plugins)
    rows.push_back({{page->name(Kind::plugin, text_of(p, "Name")), page->text(text_of(p, "Version")),
                     page->text(text_of(p, "Vendor"))}});
  page->table({"Name", "Version", "Vendor"}, rows);
  site.add(*page);
}

}  // namespace isogloss::cli::docs
