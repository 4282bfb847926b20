// The pages of dialects: the chain as a graph and as a table, tables, initial values, codes.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "dialect/chain_map.hpp"
#include "docs/site.hpp"

namespace isogloss::cli::docs {

namespace {

/// The name alone: where it lies is different on each machine.
std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

Markup attributes(const Page& page, const Json& object) {
  Markup out;
  for (const auto& [name, value] : object.items())
    out += (out.empty() ? "" : ", ") +
           page.code(name + "=\"" + (value.is_string() ? value.get<std::string>() : value.dump()) + "\"");
  return out;
}

std::map<std::string, std::string> options_of(const ShownDialect& d, const std::string& alias) {
  std::map<std::string, std::string> out;
  for (const Json& e : d.declaration["Chain"])
    if (e["As"] == alias)
      for (const auto& [name, value] : e["Options"].items()) out[name] = value.get<std::string>();
  return out;
}

class DialectPage {
 public:
  DialectPage(Site& site, const ShownDialect& dialect)
      : site_(site),
        d_(dialect),
        page_(site.page(site.addresses().find(Kind::dialect, dialect.name)->file, dialect.name)) {}

  void write() {
    page_->paragraph(page_->prose(text_of(d_.declaration, "Title")));
    page_->list(facts());
    write_contents();
    if (d_.is_linked)
      write_chain();
    else
      page_->paragraph(page_->text("This dialect does not link with the plugins that are installed: isogloss lint " +
                                   d_.name + " says why."));
    write_dependencies();
    write_initial();
    write_codes();
    site_.add(*page_);
    if (d_.is_linked && site_.format() == Format::markdown)
      site_.add_file(page_->file() + ".svg", chain_as_svg(d_.chain));
  }

 private:
  std::vector<Markup> facts() const {
    const Page& p = *page_;
    std::vector<std::string> extended_by;
    for (const ShownDialect& other : site_.reference().dialects)
      for (const std::string& base : texts(other.declaration["Extends"]))
        if (base == d_.name) extended_by.push_back(other.name);
    std::vector<Markup> out;
    const auto add = [&](std::string_view label, const Markup& value) {
      if (!value.empty()) out.push_back(fact(p, label, value));
    };
    add("File", p.code(file_name(text_of(d_.declaration, "File"))));
    add("Extends", p.names(Kind::dialect, texts(d_.declaration["Extends"])));
    add("Extended by", p.names(Kind::dialect, extended_by));
    std::vector<std::string> machines;
    for (const ShownMachine& m : site_.reference().machines)
      if (m.dialect == d_.name) machines.push_back(m.name);
    add("Machines", p.names(Kind::machine, machines));
    add("Plugins", p.names(Kind::plugin, texts(d_.declaration["Plugins"])));
    Markup extensions;
    for (const std::string& one : texts(d_.declaration["Extensions"]))
      extensions += (extensions.empty() ? "" : ", ") + p.code(one);
    add("Files of programs", extensions);
    if (const std::string segmenter = text_of(d_.declaration, "Segmenter"); !segmenter.empty())
      add("Blocks are cut by", p.code(segmenter));
    return out;
  }

  void write_contents() {
    Markup out;
    const auto add = [&](bool is_there, const char* place, std::string_view label) {
      if (is_there)
        out += (out.empty() ? "" : page_->text(" · ")) + page_->link({page_->file(), place}, page_->text(label));
    };
    add(d_.is_linked, "chain", "Chain");
    add(!d_.declaration["Dependencies"].empty(), "dependencies", "Tables and other dependencies");
    add(!d_.declaration["Initial"].empty(), "initial", "Before the first block");
    add(!d_.codes.empty(), "codes", "Codes");
    if (!out.empty()) page_->paragraph(page_->text("On this page: ") + out);
  }

  void write_chain() {
    page_->heading(2, page_->text("Chain"), "chain");
    page_->paragraph(page_->text(
        "On the left, in red: the order that syntaxes declare. On the right, in blue: the upper syntax writes a "
        "field that the lower one reads. The tables below the graph list the same chain."));
    page_->graph(d_.chain);
    for (const Json& stage : d_.chain["Stages"]) {
      const std::string name = text_of(stage, "Stage");
      page_->heading(3, page_->text(name), "stage." + file_stem(name));
      std::vector<Row> rows;
      for (const Json& s : stage["Syntaxes"]) rows.push_back(chain_row(s));
      page_->table({"Syntax", "No.", "As", "Plugin", "Options", "Answers", "Writes for"}, rows);
    }
  }

  Row chain_row(const Json& s) const {
    const Page& p = *page_;
    const std::string alias = text_of(s, "As"), id = text_of(s, "Syntax");
    Markup options, readers;
    for (const auto& [name, value] : options_of(d_, alias))
      options += (options.empty() ? "" : ", ") + p.code(name + "=\"" + value + "\"");
    std::vector<std::string> later;
    for (const Json& w : s["Writes"])
      for (std::string& reader : texts(w["For"]))
        if (std::find(later.begin(), later.end(), reader) == later.end()) later.push_back(std::move(reader));
    constexpr std::size_t most = 8;
    const std::size_t more = later.size() > most ? later.size() - most : 0;
    later.resize(later.size() - more);
    readers = p.names(Kind::part, later);
    if (more > 0) readers += p.text(fmt::format(" and {} more", more));
    std::vector<std::string> codes = texts(s["Takes"]);
    const std::size_t more_codes = codes.size() > 2 * most ? codes.size() - 2 * most : 0;
    codes.resize(codes.size() - more_codes);
    Markup answers = p.names(Kind::code, codes);
    if (more_codes > 0) answers += p.text(fmt::format(" and {} more", more_codes));
    return {{p.name(Kind::part, id), p.text(text_of(s, "Position")), alias == id ? Markup() : p.code(alias),
             p.name(Kind::plugin, text_of(s, "Plugin")), options, answers, readers}};
  }

  void write_dependencies() {
    std::vector<Row> rows;
    for (const Json& e : d_.declaration["Dependencies"]) {
      Markup answers;
      if (d_.is_linked)
        for (const Json& s : d_.services)
          if (s["Answers"] == e["As"]) answers += (answers.empty() ? "" : ", ") + page_->code(text_of(s, "Service"));
      const std::size_t count = e["Rows"].get<std::size_t>();
      rows.push_back({{page_->name(Kind::part, text_of(e, "Id")), attributes(*page_, e["Options"]),
                       count == 0 ? Markup() : page_->text(fmt::format("{}", count)), answers}});
    }
    if (rows.empty()) return;
    page_->heading(2, page_->text("Tables and other dependencies"), "dependencies");
    page_->table({"Name", "Options", "Rows", "Answers for"}, rows);
  }

  void write_initial() {
    std::vector<Row> rows;
    for (const auto& [path, value] : d_.declaration["Initial"].items())
      rows.push_back(
          {{page_->name(Kind::field, path), page_->code(value.is_string() ? value.get<std::string>() : value.dump())}});
    if (rows.empty()) return;
    page_->heading(2, page_->text("Before the first block"), "initial");
    page_->table({"Field", "Value"}, rows);
  }

  void write_codes() {
    std::map<std::string, std::string> syntaxes;
    for (const Instance& i : d_.instances) syntaxes[i.alias] = i.syntax;
    std::map<std::string, Markup, ByNumber> codes;
    for (const Json& row : d_.codes) {
      if (row["Kind"] == "word") continue;
      Markup& answers = codes[text_of(row, "Code")];
      const std::string alias = text_of(row, "Syntax");
      answers += (answers.empty() ? "" : ", ") + page_->name(Kind::part, syntaxes[alias]);
      if (alias != syntaxes[alias]) answers += page_->text(" (as " + alias + ")");
    }
    if (codes.empty()) return;
    page_->heading(2, page_->text("Codes"), "codes");
    page_->paragraph(page_->text("Each code with the syntaxes that answer it, in the order of the chain."));
    std::vector<Row> rows;
    for (const auto& [code, answers] : codes) rows.push_back({{page_->name(Kind::code, code), answers}});
    page_->table({"Code", "Answered by"}, rows);
  }

  Site& site_;
  const ShownDialect& d_;
  std::unique_ptr<Page> page_;
};

}  // namespace

void write_dialects(Site& site) {
  for (const ShownDialect& dialect : site.reference().dialects) DialectPage(site, dialect).write();
  const auto page = site.page("dialects", "Dialects");
  std::vector<Row> rows;
  for (const ShownDialect& d : site.reference().dialects)
    rows.push_back({{page->name(Kind::dialect, d.name), page->prose(text_of(d.declaration, "Title")),
                     page->names(Kind::dialect, texts(d.declaration["Extends"])),
                     page->names(Kind::plugin, texts(d.declaration["Plugins"])),
                     page->text(fmt::format("{}", d.instances.size()))}});
  page->table({"Name", "Title", "Extends", "Plugins", "Syntaxes"}, rows);
  site.add(*page);
}

}  // namespace isogloss::cli::docs
