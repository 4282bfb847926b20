// Tables as XML.
#include <fmt/format.h>
#include <pugixml.hpp>

#include <sstream>

#include "dialect/xml_source.hpp"
#include "isogloss/engine/import.hpp"

namespace isogloss {

namespace {

/// A comment holds no "--" and does not end in '-'.
std::string comment_text(std::string text) {
  for (std::size_t i = text.find("--"); i != std::string::npos; i = text.find("--", i)) text.insert(i + 1, " ");
  return " " + text + " ";
}

std::string file_name(const Location& where) { return std::filesystem::path(where.file).filename().string(); }

}  // namespace

std::string write_tables(const std::vector<DependencyElement>& tables, bool sources) {
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("Dependencies");
  for (const DependencyElement& table : tables) {
    pugi::xml_node element = root.append_child(table.id.c_str());
    if (table.alias != table.id) set_attribute(element, "as", table.alias);
    for (const Attribute& option : table.options) set_attribute(element, option.name.c_str(), option.value);
    for (const TableRow& row : table.rows) {
      if (sources)
        element.append_child(pugi::node_comment)
            .set_value(comment_text(fmt::format("{}:{}", file_name(row.where), row.where.line)).c_str());
      pugi::xml_node one = element.append_child(row.element.c_str());
      for (const Attribute& cell : row.attributes) set_attribute(one, cell.name.c_str(), cell.value);
    }
  }
  std::ostringstream out;
  document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
  return out.str();
}

}  // namespace isogloss
