#include "dap/statement_lines.hpp"

#include <algorithm>

#include "dap/breakpoints.hpp"

namespace isogloss::dap {

StatementLines::StatementLines(const LinkedDialect& linked, const RunOptions& options, const std::string& path,
                               const std::string& text)
    : linked_(linked), options_(options), path_(canonical_path(path)), text_(text) {}

const StatementLines::File& StatementLines::file(const std::string& path) {
  const std::string canonical = canonical_path(path);
  const auto [found, is_new] = files_.try_emplace(canonical);
  if (!is_new) return found->second;
  std::string error;
  const std::unique_ptr<Source> source = canonical == path_ ? memory_source(text_) : open_file(canonical, error);
  if (source == nullptr) return found->second;
  try {
    found->second.lines = find_block_lines(linked_, *source, options_);
    found->second.is_read = true;
  } catch (const std::exception&) {
    found->second.is_read = false;  // the run itself reports which syntax cannot be created
  }
  return found->second;
}

std::optional<std::uint32_t> StatementLines::statement_at(const std::string& path, std::uint32_t line) {
  const std::lock_guard lock(mutex_);
  const File& f = file(path);
  if (!f.is_read) return line;
  const auto behind = std::ranges::upper_bound(f.lines, line, {}, [](const BlockLine& block) { return block.line; });
  if (behind == f.lines.begin()) return std::nullopt;
  const BlockLine& block = *std::prev(behind);
  return line < block.line + block.lines ? std::optional(block.line) : std::nullopt;
}

bool StatementLines::is_statement(std::string_view name, std::uint32_t line) {
  const std::lock_guard lock(mutex_);
  auto found = seen_.find(name);
  if (found == seen_.end()) {
    names_.push_back(std::make_unique<std::string>(name));
    found = seen_.emplace(*names_.back(), &file(*names_.back())).first;
  }
  const File& f = *found->second;
  return !f.is_read || std::ranges::binary_search(f.lines, line, {}, [](const BlockLine& b) { return b.line; });
}

std::vector<std::uint32_t> StatementLines::between(const std::string& path, std::uint32_t first, std::uint32_t last) {
  const std::lock_guard lock(mutex_);
  std::vector<std::uint32_t> out;
  for (const BlockLine& block : file(path).lines)
    if (block.line >= first && block.line <= last) out.push_back(block.line);
  return out;
}

}  // namespace isogloss::dap
