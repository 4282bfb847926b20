// The pages of syntaxes, dependencies and importers: what the plugin wrote, then what it declares.
#include <fmt/format.h>

#include "docs/site.hpp"

namespace isogloss::cli::docs {

namespace {

std::string number(const Json& value) { return fmt::format("{}", value.get<double>()); }

Markup range(const Page& page, const Json& o) {
  Markup out;
  const std::string choices = text_of(o, "Choices");
  for (std::size_t at = 0; at < choices.size();) {
    const std::size_t end = std::min(choices.find('|', at), choices.size());
    out += (out.empty() ? "" : ", ") + page.code(choices.substr(at, end - at));
    at = end + 1;
  }
  if (!out.empty()) return out;
  const bool from = o.contains("Minimum"), to = o.contains("Maximum");
  return from && to ? page.text(number(o["Minimum"]) + " to " + number(o["Maximum"]))
         : from     ? page.text("from " + number(o["Minimum"]))
         : to       ? page.text("up to " + number(o["Maximum"]))
                    : Markup();
}

Markup fallback(const Page& page, const Json& o) {
  if (o.contains("MustBeGiven")) return page.text("must be given");
  const std::string value = text_of(o, "Default");
  return !value.empty() ? page.code(value) : o.contains("Default") ? page.text("(empty)") : Markup();
}

Markup service_names(const Page& page, const Json& services) {
  Markup out;
  for (const Json& s : services) {
    out += (out.empty() ? "" : ", ") + page.code(text_of(s, "Id"));
    if (s.value("Optional", false)) out += page.text(" (optional)");
  }
  return out;
}

/// Codes that the syntax answers in some dialect; words, which many take, are not among them.
Markup answered_codes(const Page& page, const Site& site, const std::string& syntax) {
  constexpr std::size_t most = 40;
  Markup out;
  std::size_t count = 0;
  for (const auto& [name, code] : site.reference().codes)
    for (const CodeAnswer& answer : code.answers)
      if (!code.is_word && answer.syntax == syntax && ++count <= most)
        out += (out.empty() ? "" : ", ") + page.name(Kind::code, name);
  return count > most ? out + page.text(fmt::format(" and {} more", count - most)) : out;
}

class PartPage {
 public:
  PartPage(Site& site, const Part& part)
      : site_(site), part_(part), page_(site.page(site.addresses().find(Kind::part, part.id)->file, part.id)) {}

  void write() {
    page_->paragraph(page_->prose(text_of(part_.declaration, "Summary")));
    page_->list(facts());
    write_contents();
    if (!part_.page.empty()) site_.add_text(*page_, part_.id, part_.page);
    if (!part_.cases.empty()) write_further_cases();
    write_options(*page_, part_.declaration["Options"]);
    if (part_.kind == PartKind::syntax) write_instances();
    if (part_.kind == PartKind::syntax) write_field_table();
    if (part_.kind == PartKind::dependency) write_columns();
    site_.add(*page_);
  }

 private:
  std::vector<Markup> facts() const {
    const Json& d = part_.declaration;
    const Page& p = *page_;
    std::vector<Markup> out;
    const auto add = [&](std::string_view label, const Markup& value) {
      if (!value.empty()) out.push_back(fact(p, label, value));
    };
    const auto parts = [&](const char* key) { return d.contains(key) ? p.names(Kind::part, texts(d[key])) : Markup(); };
    const auto plain = [&](const char* key) { return d.contains(key) ? p.code(text_of(d, key)) : Markup(); };
    add("Plugin", p.name(Kind::plugin, part_.plugin));
    add("Dialects", p.names(Kind::dialect, dialects()));
    add("Codes", part_.kind == PartKind::syntax ? answered_codes(p, site_, part_.id) : Markup());
    add("Stands after", parts("After"));
    add("Stands before", parts("Before"));
    add("Exclusive slot", plain("ExclusiveSlot"));
    add("First-writer slot", plain("FirstWriterSlot"));
    add("Scans", plain("Scans"));
    if (d.contains("ScansAhead")) add("Scans ahead of its turn", p.text("yes"));
    add("Looks ahead, blocks", plain("LookAhead"));
    if (d.contains("Services")) add("Services", service_names(p, d["Services"]));
    if (d.contains("Provides")) {
      Markup provided;
      for (const std::string& id : texts(d["Provides"])) provided += (provided.empty() ? "" : ", ") + p.code(id);
      add("Provides", provided);
    }
    add("Files", plain("Files"));
    add("Tables", parts("Tables"));
    if (part_.kind == PartKind::importer) add("Writes such files", p.text(d.value("Writes", false) ? "yes" : "no"));
    return out;
  }

  /// What stands below the plugin's own text, which may be long.
  void write_contents() {
    const auto has = [&](const char* key) {
      return part_.declaration.contains(key) && !part_.declaration[key].empty();
    };
    Markup out;
    const auto add = [&](bool is_there, const Address& to, std::string_view label) {
      if (is_there) out += (out.empty() ? "" : page_->text(" · ")) + page_->link(to, page_->text(label));
    };
    const std::string& file = page_->file();
    add(!part_.cases.empty(), {file + ".cases", {}}, "Further cases");
    add(has("Options"), {file, "options."}, "Options");
    add(has("Columns"), {file, "columns."}, "Columns");
    add(part_.kind == PartKind::syntax && !dialects().empty(), {file, "in-dialects."}, "In dialects");
    add(has("Fields"), {file, "fields."}, "Fields");
    if (!out.empty()) page_->paragraph(page_->text("Below the text: ") + out);
  }

  std::vector<std::string> dialects() const {
    std::vector<std::string> out;
    for (const ShownDialect& d : site_.reference().dialects) {
      bool is_there = false;
      for (const Instance& i : d.instances) is_there = is_there || i.syntax == part_.id;
      for (const Json& e : d.declaration["Dependencies"]) is_there = is_there || e["Id"] == part_.id;
      if (is_there) out.push_back(d.name);
    }
    return out;
  }

  void write_further_cases() {
    const std::string file = page_->file() + ".cases";
    const auto cases = site_.page(file, part_.id + ": further cases");
    cases->paragraph(cases->text("The syntax or importer is described on its page, ") +
                     cases->name(Kind::part, part_.id) + cases->text("."));
    site_.add_text(*cases, part_.id, part_.cases);
    site_.add(*cases);
  }

  /// What dialects change of the options.
  void write_instances() {
    std::map<std::string, std::string> defaults;
    for (const Json& o : part_.declaration["Options"]) defaults[text_of(o, "Name")] = text_of(o, "Default");
    std::vector<Row> rows;
    for (const ShownDialect& d : site_.reference().dialects)
      for (const Instance& i : d.instances) {
        if (i.syntax != part_.id) continue;
        Markup set;
        for (const auto& [name, value] : i.link["Options"].items())
          if (value != defaults[name])
            set += (set.empty() ? "" : ", ") + page_->code(name + "=\"" + value.get<std::string>() + "\"");
        rows.push_back({{page_->name(Kind::dialect, d.name), page_->text(text_of(i.link, "Stage")),
                         i.alias == part_.id ? Markup() : page_->code(i.alias), set}});
      }
    if (rows.empty()) return;
    page_->heading(2, page_->text("In dialects"), "in-dialects.");
    page_->table({"Dialect", "Stage", "As", "Options that are not the default"}, rows);
  }

  void write_field_table() {
    std::vector<Row> rows;
    for (const Json& f : part_.declaration["Fields"]) {
      std::string access;
      for (const std::string& word : texts(f["Access"])) access += (access.empty() ? "" : ", ") + word;
      rows.push_back({{page_->name(Kind::field, text_of(f, "Path")), page_->text(text_of(f, "Type")),
                       page_->text(text_of(f, "Unit")), page_->text(access), page_->prose(text_of(f, "Doc"))}});
    }
    if (rows.empty()) return;
    page_->heading(2, page_->text("Fields"), "fields.");
    page_->table({"Field", "Type", "Unit", "Access", "Meaning"}, rows);
  }

  void write_columns() {
    const Json& d = part_.declaration;
    if (!d.contains("Columns")) return;
    page_->heading(2, page_->text("Columns"), "columns.");
    page_->paragraph(page_->text("One row is ") + page_->code("<" + text_of(d, "Row") + ">") +
                     page_->text(", named by ") + page_->code(text_of(d, "Key")) + page_->text("."));
    std::vector<Row> rows;
    for (const Json& c : d["Columns"])
      rows.push_back({{page_->code(text_of(c, "Name")), page_->text(text_of(c, "Type")), range(*page_, c),
                       fallback(*page_, c), page_->text(text_of(c, "Unit")), page_->prose(text_of(c, "Doc"))}});
    page_->table({"Column", "Type", "Range", "Default", "Unit", "Meaning"}, rows);
  }

  Site& site_;
  const Part& part_;
  std::unique_ptr<Page> page_;
};

void write_list(Site& site, PartKind kind, const std::string& file, const std::string& title) {
  const auto page = site.page(file, title);
  std::vector<Row> rows;
  for (const Part& part : site.reference().parts)
    if (part.kind == kind)
      rows.push_back({{page->name(Kind::part, part.id), page->name(Kind::plugin, part.plugin),
                       page->prose(text_of(part.declaration, "Summary"))}});
  if (rows.empty()) page->paragraph(page->text("No plugin has one."));
  page->table({"Name", "Plugin", "Summary"}, rows);
  site.add(*page);
}

}  // namespace

void write_options(Page& page, const Json& options) {
  std::vector<Row> rows;
  for (const Json& o : options)
    rows.push_back({{page.code(text_of(o, "Name")), page.text(text_of(o, "Type")), range(page, o), fallback(page, o),
                     page.text(text_of(o, "Unit")), page.prose(text_of(o, "Doc"))}});
  if (rows.empty()) return;
  page.heading(2, page.text("Options"), "options.");
  page.table({"Option", "Type", "Range", "Default", "Unit", "Meaning"}, rows);
}

void write_parts(Site& site) {
  for (const Part& part : site.reference().parts) PartPage(site, part).write();
  write_list(site, PartKind::syntax, "syntaxes", "Syntaxes");
  write_list(site, PartKind::dependency, "tables", "Tables and other dependencies");
  write_list(site, PartKind::importer, "importers", "Importers");
}

}  // namespace isogloss::cli::docs
