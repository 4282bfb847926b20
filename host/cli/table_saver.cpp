#include "table_saver.hpp"

#include <filesystem>
#include <pugixml.hpp>
#include <sstream>

#include "isogloss/engine/chain.hpp"
#include "output_file.hpp"

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
      if (const std::string text(table.text(key, column)); !text.empty())
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
      session_.report("IG-0513", {}, {"--save-table: the dialect has no table " + name});
      return;
    }
    std::string error;
    const std::unique_ptr<OutputFile> out = OutputFile::open(file, error);
    if (out != nullptr && (!out->write(xml_of(*table, name)) || !out->commit())) error = out->error();
    if (!error.empty()) session_.report("IG-0511", {file}, {error});
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

bool are_apart(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs, Session& session) {
  namespace fs = std::filesystem;
  std::error_code code;
  const auto is_replaced = [&](const std::string& file) {
    const fs::file_status status = fs::status(file, code);
    return !file.empty() && file != "-" && (!fs::exists(status) || fs::is_regular_file(status));
  };
  const auto are_one = [&](const std::string& a, const std::string& b) { return fs::equivalent(a, b, code); };
  // Both outputs may not exist yet.
  const auto have_one_name = [&](const std::string& a, const std::string& b) {
    return are_one(a, b) || fs::weakly_canonical(fs::absolute(a), code) == fs::weakly_canonical(fs::absolute(b), code);
  };
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!is_replaced(outputs[i])) continue;
    for (const std::string& input : inputs)
      if (!input.empty() && input != "-" && are_one(input, outputs[i])) {
        session.report_to_stderr();
        session.report("IG-0530", {outputs[i]}, {input});
        return false;
      }
    for (std::size_t k = 0; k < i; ++k)
      if (is_replaced(outputs[k]) && have_one_name(outputs[k], outputs[i])) {
        session.report_to_stderr();
        session.report("IG-0531", {outputs[i]}, {outputs[k]});
        return false;
      }
  }
  return true;
}

std::unique_ptr<Exporter> make_table_saver(const std::vector<TableRequest>& requests, Session& session) {
  return std::make_unique<TableSaver>(requests, session);
}

}  // namespace isogloss::cli
