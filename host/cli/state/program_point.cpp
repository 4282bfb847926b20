#include "state/program_point.hpp"

#include <filesystem>

namespace isogloss::cli {

PointFinder::Rows PointFinder::rows_of(const DependencyTable& table) {
  const ig_dependency& d = table.dependency();
  Rows out;
  for (const std::string& row : table.rows())
    for (std::uint32_t column = 0; column < d.column_count; ++column)
      if (const std::string text(table.text(row, column)); !text.empty()) out[row][d.columns[column].name] = text;
  return out;
}

void PointFinder::begin(Document& initial, const SymbolTable&) {
  chain_ = initial.chain;
  variable_ = initial.layout().id("Vars.Variable");
  value_ = initial.layout().id("Vars.Value");
  for (const LinkedDependency& d : chain_->linked().dependencies)
    if (const DependencyTable* const table = chain_->table(d.element.alias);
        table != nullptr && d.dependency->row_element != nullptr)
      before_[d.element.alias] = rows_of(*table);
}

bool PointFinder::block(Document& document, const SymbolTable&) {
  if (is_found) return false;  // blocks that waited for others still come
  const BlockSource& source = document.source;
  const std::filesystem::path file(source.file);
  if (source.line == line_ && (source.file == file_ || file.filename() == file_)) {
    is_found = true;
    find_changes();
    return false;
  }
  ++blocks_before;
  if (document.fresh(variable_))
    variables[document.value(variable_).integer] =
        document.fresh(value_) ? std::optional(document.number(value_)) : std::nullopt;
  return true;
}

void PointFinder::find_changes() {
  for (const LinkedDependency& d : chain_->linked().dependencies) {
    const auto before = before_.find(d.element.alias);
    if (before == before_.end()) continue;
    DependencyElement changed = d.element;
    changed.rows.clear();
    changed.options.clear();
    changed.source_file.clear();
    for (const auto& [row, cells] : rows_of(*chain_->table(d.element.alias))) {
      if (const auto old = before->second.find(row); old != before->second.end() && old->second == cells) continue;
      TableRow one{d.dependency->row_element, {{d.dependency->row_key, row, {}}}, {}};
      for (const auto& [column, text] : cells) one.attributes.push_back({column, text, {}});
      changed.rows.push_back(std::move(one));
    }
    if (!changed.rows.empty()) changed_tables.push_back(std::move(changed));
  }
}

std::optional<ProgramPoint> find_point(const LinkedDialect& linked, const std::string& text, const std::string& name,
                                       const ExplainTarget& target, const RunOptions& options, DiagnosticSink& sink,
                                       ExplainReach& reach) {
  const std::unique_ptr<Source> source = memory_source(text);
  std::vector<ExplainedBlock> blocks = explain(linked, *source, name, target, options, sink, &reach);
  if (blocks.empty()) return std::nullopt;
  ProgramPoint out;
  out.block = std::move(blocks.front());
  if (target.pass > 1) return out;
  PointFinder finder(out.block.where.line, target.file.empty() ? out.block.where.file : target.file);
  DiagnosticList heard_already;
  const std::unique_ptr<Source> again = memory_source(text);
  run(linked, *again, name, options, {&finder}, heard_already);
  out.blocks_before = finder.blocks_before;
  out.variables = std::move(finder.variables);
  out.changed_tables = std::move(finder.changed_tables);
  return out;
}

}  // namespace isogloss::cli
