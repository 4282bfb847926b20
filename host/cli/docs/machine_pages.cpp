// The pages of machines: the dialect, the axes, each row of each table with the file that gave it, and the programs.
#include <fmt/format.h>

#include <algorithm>

#include "docs/site.hpp"

namespace isogloss::cli::docs {

namespace {

/// Columns in the order in which the rows first name them.
std::vector<std::string> columns_of(const Json& rows) {
  std::vector<std::string> out;
  for (const Json& row : rows)
    for (const auto& [name, value] : row["Values"].items())
      if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
  return out;
}

class MachinePage {
 public:
  MachinePage(Site& site, const ShownMachine& machine)
      : site_(site),
        m_(machine),
        page_(site.page(site.addresses().find(Kind::machine, machine.name)->file, machine.name)) {}

  void write() {
    if (!m_.title.empty()) page_->paragraph(page_->prose(m_.title));
    page_->list(facts());
    if (!m_.is_whole)
      page_->paragraph(page_->text("This machine is not complete with what is installed: isogloss lint -m " + m_.name +
                                   " says why."));
    write_contents();
    write_axes();
    for (const Json& table : m_.tables) write_table(table);
    write_programs();
    write_lacking();
    site_.add(*page_);
  }

 private:
  std::vector<Markup> facts() const {
    std::vector<Markup> out{fact(*page_, "File", page_->code(m_.file))};
    out.push_back(fact(*page_, "Dialect",
                       m_.is_tables ? page_->text("any, because the file holds tables alone: isogloss run --machine " +
                                                  m_.name + " puts them on a dialect")
                                    : page_->name(Kind::dialect, m_.dialect)));
    return out;
  }

  void write_contents() {
    Markup out;
    const auto add = [&](bool is_there, const std::string& place, std::string_view label) {
      if (is_there)
        out += (out.empty() ? "" : page_->text(" · ")) + page_->link({page_->file(), place}, page_->text(label));
    };
    add(!m_.axes.empty(), "axes", "Axes and named positions");
    for (const Json& table : m_.tables) add(true, place_of(table), text_of(table, "As"));
    add(!m_.programs.empty(), "programs", "Programs");
    add(!m_.lacks.empty(), "lacks", "What the machine lacks");
    if (!out.empty()) page_->paragraph(page_->text("On this page: ") + out);
    if (!m_.tables.empty())
      page_->paragraph(
          page_->text("Each row names the file and the line that gave it; where several files gave cells of one row, "
                      "the last of them."));
  }

  static std::string place_of(const Json& table) { return "table." + file_stem(text_of(table, "As")); }

  /// The column of a table, as its plugin declares it; null where there is none.
  const Json* declared(const std::string& dependency, const std::string& column) const {
    for (const Part& part : site_.reference().parts)
      if (part.kind == PartKind::dependency && part.id == dependency && part.declaration.contains("Columns"))
        for (const Json& one : part.declaration["Columns"])
          if (one["Name"] == column) return &one;
    return nullptr;
  }

  /// Axes are few and what is known of each is much, so an axis is a column.
  void write_axes() {
    std::vector<std::string> head{"Value", "Meaning", "Unit"}, values;
    for (const Json& axis : m_.axes) {
      head.push_back(text_of(axis, "Axis"));
      for (const auto& [name, value] : axis.items())
        if (name != "Axis" && std::find(values.begin(), values.end(), name) == values.end()) values.push_back(name);
    }
    std::vector<Row> rows;
    for (const std::string& name : values) {
      const Json* const column = declared(m_.axis_table, name);
      Row row{{page_->code(name), column == nullptr ? Markup() : page_->prose(text_of(*column, "Doc")),
               column == nullptr ? Markup() : page_->text(text_of(*column, "Unit"))}};
      for (const Json& axis : m_.axes) row.cells.push_back(page_->text(text_of(axis, name.c_str())));
      rows.push_back(std::move(row));
    }
    if (rows.empty()) return;
    page_->heading(2, page_->text("Axes and named positions"), "axes");
    page_->paragraph(page_->text("In machine coordinates. The table below says which file gave each value: ") +
                     page_->link({page_->file(), "table." + file_stem(m_.axis_table)}, page_->text(m_.axis_table)));
    page_->table(head, rows);
  }

  void write_table(const Json& table) {
    const std::string id = text_of(table, "Id"), alias = text_of(table, "As");
    page_->heading(2, page_->text(alias), place_of(table));
    Markup about = page_->name(Kind::part, id);
    for (const Part& part : site_.reference().parts)
      if (part.kind == PartKind::dependency && part.id == id)
        about += page_->text(": ") + page_->prose(text_of(part.declaration, "Summary"));
    for (const auto& [name, value] : table["Options"].items())
      about += page_->text(" ") + page_->code(name + "=\"" + value.get<std::string>() + "\"");
    page_->paragraph(about);
    const Json& all = table["Rows"];
    constexpr std::size_t most = 500;
    const std::vector<std::string> columns = columns_of(all);
    std::vector<std::string> head = columns;
    head.emplace_back("From");
    std::vector<Row> rows;
    for (const Json& row : all) {
      if (rows.size() == most) break;
      Row shown;
      for (const std::string& column : columns)
        shown.cells.push_back(page_->text(text_of(row["Values"], column.c_str())));
      shown.cells.push_back(page_->code(text_of(row, "From")));
      rows.push_back(std::move(shown));
    }
    page_->table(head, rows);
    if (all.size() > most)
      page_->paragraph(
          page_->text(fmt::format("and {} more rows, which isogloss export -m {} writes", all.size() - most, m_.name)));
  }

  void write_programs() {
    if (m_.programs.empty()) return;
    page_->heading(2, page_->text("Programs"), "programs");
    page_->paragraph(
        page_->text("Called programs are looked for in these folders, after the folder of the main program."));
    std::vector<Row> rows;
    for (const Json& folder : m_.programs) {
      Markup files;
      for (const std::string& file : texts(folder["Files"])) files += (files.empty() ? "" : ", ") + page_->code(file);
      rows.push_back({{page_->code(text_of(folder, "Folder")), files}});
    }
    page_->table({"Folder", "Files"}, rows);
  }

  void write_lacking() {
    std::vector<Row> rows;
    for (const Json& lack : m_.lacks)
      rows.push_back({{page_->code(text_of(lack, "Service")), page_->text(text_of(lack, "Need")),
                       page_->prose(text_of(lack, "For")), page_->names(Kind::part, texts(lack["Asked by"])),
                       page_->names(Kind::part, texts(lack["Offered by"]))}});
    if (rows.empty()) return;
    page_->heading(2, page_->text("What the machine lacks"), "lacks");
    page_->paragraph(
        page_->text("Syntaxes of the dialect ask for these services, and no table of the machine answers."));
    page_->table({"Service", "Need", "For", "Asked by", "Offered by"}, rows);
  }

  Site& site_;
  const ShownMachine& m_;
  std::unique_ptr<Page> page_;
};

}  // namespace

void write_machines(Site& site) {
  const auto page = site.page("machines", "Machines");
  page->paragraph(page->text(
      "A machine has tables, programs and files of its control on top of a dialect: isogloss run PROGRAM -m NAME"));
  std::vector<Row> rows;
  for (const ShownMachine& m : site.reference().machines) {
    MachinePage(site, m).write();
    rows.push_back({{page->name(Kind::machine, m.name), page->prose(m.title),
                     m.is_tables ? page->text("any (tables alone)") : page->name(Kind::dialect, m.dialect)}});
  }
  page->table({"Name", "Title", "Dialect"}, rows);
  site.add(*page);
}

}  // namespace isogloss::cli::docs
