#include "state/program_point.hpp"

#include <isogloss_flow.h>

#include <filesystem>

#include "asked_reports.hpp"

namespace isogloss::cli {

PointFinder::Rows PointFinder::rows_of(const DependencyTable& table) {
  const ig_dependency& d = table.dependency();
  Rows out;
  for (const std::string& row : table.rows())
    for (std::uint32_t column = 0; column < d.column_count; ++column)
      if (const std::string text(table.text(row, column)); !text.empty()) out[row][d.columns[column].name] = text;
  return out;
}

PointFinder::PointFinder(std::uint32_t line, std::string file, ProgramLines* lines)
    : line_(line), file_(std::move(file)), lines_(lines) {}

bool PointFinder::is_at_line(const BlockSource& source) const {
  return source.line == line_ && (source.file == file_ || std::filesystem::path(source.file).filename() == file_);
}

void PointFinder::listen(Chain& chain) {
  chain_ = &chain;
  flow_ = static_cast<const ig_flow_1*>(chain.service(IG_FLOW_SERVICE));
  chain.listen_to_rows();
  chain.variable_used = [this](const Document&, bool is_write, std::string_view name, std::uint64_t scope,
                               const ig_argument* value) {
    ig_frame caller{};
    caller.struct_size = sizeof caller;
    const bool is_called = flow_ != nullptr && flow_->frame(chain_->document().block(), 1, &caller) != 0;
    const BlockSource& at = chain_->document().source;
    notice(at);
    variables_.use(at, is_write, name, scope, is_called, value);
  };
  // A block that looks ahead is finished later than those behind it are built, so the line is noticed as it is read.
  chain.scanned = [this](std::uint32_t, std::size_t, std::size_t) { notice(chain_->document().source); };
}

void PointFinder::begin(Document& initial, const SymbolTable& symbols) {
  clear_level_.begin(initial, symbols);
  axis_places_.begin(initial, symbols);
  tools_.begin(initial, symbols);
  codes_.begin(initial.layout());
  for (const LinkedDependency& d : chain_->linked().dependencies)
    if (const DependencyTable* const table = chain_->table(d.element.alias);
        table != nullptr && d.dependency->row_element != nullptr)
      before_[d.element.alias] = rows_of(*table);
}

bool PointFinder::block(Document& document, const SymbolTable& symbols) {
  if (is_found_) return !variables_.is_decided();
  const BlockSource& source = document.source;
  if (main_file_.empty()) main_file_ = source.file;
  if (is_at_line(source)) {
    is_found_ = true;
    notice(source);
    return !variables_.is_decided();
  }
  ++blocks_before_;
  if (lines_ != nullptr) lines_->note(source);
  clear_level_.block(document, symbols);
  axis_places_.block(document, symbols);
  tools_.block(document, symbols);
  codes_.block(document);
  if (source.file == main_file_) note_line(source);
  return true;
}

/// Before the block of the line acts: it may change tables and variables itself.
void PointFinder::notice(const BlockSource& source) {
  if (variables_.is_behind() || !is_at_line(source)) return;
  variables_.pass();
  find_changes();
}

void PointFinder::note_line(const BlockSource& source) {
  if (++times_[source.line] == 1) order_.push_back(source.line);
}

void PointFinder::tell(ProgramPoint& out) {
  out.blocks_before = blocks_before_;
  out.variables = variables_.all();
  out.changed_tables = std::move(changed_tables_);
  out.clear_level = clear_level_.at_point();
  out.place = clear_level_.place();
  out.places = axis_places_.places();
  out.tools = std::move(tools_);
  out.codes = std::move(codes_);
  constexpr std::size_t most_lines = 1000;
  for (std::size_t i = order_.size() > most_lines ? order_.size() - most_lines : 0; i < order_.size(); ++i)
    if (times_[order_[i]] == 1) out.lines_before.push_back(order_[i]);
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
    if (!changed.rows.empty()) changed_tables_.push_back(std::move(changed));
  }
}

std::optional<ProgramPoint> find_point(const LinkedDialect& linked, const std::string& text, const std::string& name,
                                       const ExplainTarget& target, const RunOptions& options, DiagnosticSink& sink,
                                       ExplainReach& reach, ProgramLines* lines) {
  const std::unique_ptr<Source> source = memory_source(text);
  std::vector<ExplainedBlock> blocks = explain(linked, *source, name, target, options, sink, &reach);
  if (blocks.empty()) return std::nullopt;
  ProgramPoint out;
  out.block = std::move(blocks.front());
  if (target.pass > 1) return out;
  PointFinder finder(out.block.where.line, target.file.empty() ? out.block.where.file : target.file, lines);
  RunOptions heard = options;
  heard.prepare = [&](Chain& chain) {
    if (options.prepare) options.prepare(chain);
    finder.listen(chain);
  };
  Unheard heard_already;
  const std::unique_ptr<Source> again = memory_source(text);
  run(linked, *again, name, heard, {&finder}, heard_already);
  finder.tell(out);
  return out;
}

}  // namespace isogloss::cli
