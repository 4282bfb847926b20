#include "table_saver.hpp"

#include <pugixml.hpp>
#include <sstream>

#include "isogloss/engine/chain.hpp"
#include "outputs.hpp"

namespace isogloss::cli {

namespace {

/// The root is named as the dependency, one element a row: which a run reads as a table.
std::string xml_of(const DependencyTable& table, const std::string& name) {
  const ig_dependency& d = table.dependency();
  pugi::xml_document document;
  pugi::xml_node root = document.append_child(d.id);
  if (name != d.id) root.append_attribute("as").set_value(name.c_str());
  for (const std::string& key : table.rows()) {
    pugi::xml_node row = root.append_child(d.row_element);
    row.append_attribute(d.row_key).set_value(key.c_str());
    for (std::uint32_t column = 0; column < d.column_count; ++column)
      // An empty text is written where a program has set it: it replaces the text that the dialect gives.
      if (const std::string text(table.text(key, column)); !text.empty() || table.value(key, column))
        row.append_attribute(d.columns[column].name).set_value(text.c_str());
  }
  std::ostringstream out;
  document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
  return out.str();
}

class TableSaver : public Exporter {
 public:
  TableSaver(const std::vector<TableRequest>& requests, Session& session) : requests_(requests), session_(session) {}

  void begin(Document& initial, const SymbolTable&) override { chain_ = initial.chain; }
  bool block(Document&, const SymbolTable&) override { return true; }
  bool end() override {
    if (session_.diagnostics().by_code().contains("IG-0431")) return true;  // the program was run only in part
    for (const auto& [name, file] : requests_) save(name, file);
    return true;
  }

 private:
  void save(const std::string& name, const std::string& file) {
    const DependencyTable* const table = chain_->table(name);
    if (table == nullptr || table->dependency().row_element == nullptr) {
      std::vector<std::string> names;
      for (const LinkedDependency& d : chain_->linked().dependencies)
        if (d.dependency->row_element != nullptr) names.push_back(d.element.alias);
      const std::string near = nearest_name(name, names);
      session_.report("IG-0513", {}, {"--save-table: the dialect has no table " + name},
                      near.empty() ? "" : "did you mean " + near + "?");
      return;
    }
    write_file(file, xml_of(*table, name), session_);
  }

  const std::vector<TableRequest>& requests_;
  Session& session_;
  Chain* chain_ = nullptr;
};

}  // namespace

std::optional<std::vector<TableRequest>> read_table_requests(const std::vector<std::string>& texts, Session& session) {
  std::vector<TableRequest> out;
  bool sound = true;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
      session.report("IG-0513", {}, {"--save-table needs NAME=FILE, not '" + text + "'"});
      sound = false;
    } else {
      out.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
  }
  return sound ? std::optional(std::move(out)) : std::nullopt;
}

std::unique_ptr<Exporter> make_table_saver(const std::vector<TableRequest>& requests, Session& session) {
  return std::make_unique<TableSaver>(requests, session);
}

}  // namespace isogloss::cli
