#include "completion/completion_parts.hpp"

#include <algorithm>

#include "page_section.hpp"

namespace isogloss::cli {

namespace {

std::string text_of(const char* text) { return text == nullptr ? "" : text; }

Completion part(std::string name, std::string description) { return {std::move(name), std::move(description), false}; }

/// A table, with the rows of a dialect.
struct Table {
  std::string name;
  const ig_dependency* declared;
  const std::vector<TableRow>* rows = nullptr;
};

/// Those of the dialect or machine of the line; without one, all that are installed.
std::vector<Table> tables_of(const LinkedDialect* linked, Library& library) {
  std::vector<Table> out;
  if (linked != nullptr) {
    for (const LinkedDependency& d : linked->dependencies)
      out.push_back({d.element.alias, d.dependency, &d.element.rows});
    return out;
  }
  library.load_all();
  for (const LoadedPlugin& p : library.plugins())
    for (std::uint32_t i = 0; i < p.plugin->dependency_count; ++i)
      out.push_back({p.plugin->dependencies[i]->id, p.plugin->dependencies[i]});
  return out;
}

std::vector<std::string> row_names(const Table& table) {
  std::vector<std::string> out;
  const std::string key = text_of(table.declared->row_key);
  if (table.rows != nullptr)
    for (const TableRow& row : *table.rows)
      for (const Attribute& cell : row.attributes)
        if (cell.name == key) out.push_back(cell.value);
  for (std::uint32_t i = 0; i < table.declared->default_row_count; ++i) {
    const std::string row = table.declared->default_rows[i];
    out.push_back(row.substr(0, row.find('|')));
  }
  std::sort(out.begin(), out.end(), ByNumber{});
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// What may follow "TABLE.": an option of the dependency, or the key of a row.
void add_options_and_rows(const Table& table, const std::string& begin, std::vector<Completion>& out) {
  for (std::uint32_t i = 0; i < table.declared->option_count; ++i)
    out.push_back(part(begin + table.declared->options[i].name + "=", text_of(table.declared->options[i].doc)));
  for (const std::string& name : row_names(table)) out.push_back(part(begin + name + ".", "a row"));
}

void add_values(const ig_option_decl& option, std::vector<Completion>& out) {
  const std::string choices = text_of(option.choices);
  for (std::size_t at = 0; at < choices.size();) {
    const std::size_t end = std::min(choices.find('|', at), choices.size());
    out.push_back({std::string(option.name) + "=" + choices.substr(at, end - at), {}, true});
    at = end + 1;
  }
}

const char* page_of(const std::string& name, Library& library) {
  if (const ig_syntax* const syntax = library.syntax(name)) return syntax->page;
  if (const ig_dependency* const dependency = library.dependency(name)) return dependency->page;
  if (const ig_importer* const importer = library.importer(name)) return importer->page;
  return nullptr;
}

}  // namespace

std::vector<Completion> settings_of(const TypedLine& line, Session& session) {
  const auto named = session.dialect_or_machine(line.dialect, line.machine);
  if (!named || line.word.find('=') != std::string::npos) return {};
  const std::unique_ptr<LinkedDialect> linked = named->empty() ? nullptr : session.link(*named);
  const std::size_t first = line.word.find('.'), last = line.word.rfind('.');
  std::vector<Completion> out;
  for (const Table& table : tables_of(linked.get(), session.library())) {
    const std::string begin = table.name + ".";
    if (first == std::string::npos) out.push_back(part(begin, text_of(table.declared->summary)));
    if (!line.word.starts_with(begin)) continue;
    add_options_and_rows(table, begin, out);  // a row's name may hold a point: G54.1P1
    for (std::uint32_t i = 0; first != last && i < table.declared->column_count; ++i)
      out.push_back(part(line.word.substr(0, last + 1) + table.declared->columns[i].name + "=",
                         text_of(table.declared->columns[i].doc)));
  }
  return out;
}

std::vector<Completion> importer_options_of(const TypedLine& line, Session& session) {
  session.library().load_all();
  const bool has_sign = line.word.find('=') != std::string::npos;
  std::vector<Completion> out;
  for (const LoadedPlugin& p : session.library().plugins())
    for (std::uint32_t i = 0; i < p.plugin->importer_count; ++i) {
      const ig_importer& importer = *p.plugin->importers[i];
      if (!line.format.empty() && line.format != importer.id) continue;
      for (std::uint32_t k = 0; k < importer.option_count; ++k) {
        const ig_option_decl& option = importer.options[k];
        if (has_sign)
          add_values(option, out);
        else
          out.push_back(part(std::string(option.name) + "=", text_of(option.doc)));
      }
    }
  std::sort(out.begin(), out.end(), [](const Completion& a, const Completion& b) { return a.text < b.text; });
  out.erase(
      std::unique(out.begin(), out.end(), [](const Completion& a, const Completion& b) { return a.text == b.text; }),
      out.end());
  return out;
}

std::vector<Completion> headings_of(const TypedLine& line, Session& session) {
  session.library().load_all();
  std::vector<Completion> out;
  const char* const page = page_of(line.operand, session.library());
  if (page == nullptr) return out;
  for (std::string& title : headings(printable_page(page))) out.push_back({std::move(title), {}, true});
  return out;
}

}  // namespace isogloss::cli
