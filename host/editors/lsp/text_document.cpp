#include "lsp/text_document.hpp"

#include <algorithm>

#include "isogloss/engine/byte_order_mark.hpp"

namespace isogloss::editors {

namespace {

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// Code units of UTF-16 for the character that begins with this byte.
std::uint32_t units_of(char first) { return static_cast<unsigned char>(first) >= 0xf0 ? 2 : 1; }

}  // namespace

void TextDocument::replace_all(std::string text) {
  text_ = std::move(text);
  find_lines();
}

void TextDocument::replace(const Range& range, std::string_view with) {
  std::size_t begin = offset_of(range.start), end = offset_of(range.end);
  if (end < begin) std::swap(begin, end);
  text_.replace(begin, end - begin, with);
  find_lines();
}

void TextDocument::find_lines() {
  counted_ = {};
  const bool has_feeds = text_.find('\n') != std::string::npos;
  lines_.assign(1, 0);
  run_lines_.assign(1, text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
  if (text_.find('\r') == std::string::npos) {
    // The usual text: one look at each byte, by memchr.
    for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1)) {
      lines_.push_back(at + 1);
      run_lines_.push_back(at + 1);
    }
    return;
  }
  for (std::size_t at = text_.find_first_of("\r\n"); at != std::string::npos;
       at = text_.find_first_of("\r\n", at + 1)) {
    const bool is_feed = text_[at] == '\n';
    if (is_feed || at + 1 == text_.size() || text_[at + 1] != '\n') lines_.push_back(at + 1);
    if (is_feed || !has_feeds) run_lines_.push_back(at + 1);
  }
}

std::size_t TextDocument::end_of(std::size_t line) const {
  std::size_t end = line + 1 < lines_.size() ? lines_[line + 1] : text_.size();
  while (end > lines_[line] && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
  return end;
}

std::string_view TextDocument::line(std::size_t index) const {
  if (index >= lines_.size()) return {};
  return std::string_view(text_).substr(lines_[index], end_of(index) - lines_[index]);
}

std::size_t TextDocument::offset_of(const Position& position) const {
  if (position.line >= lines_.size()) return text_.size();
  const std::size_t begin = lines_[position.line], end = end_of(position.line);
  if (columns_ == Columns::utf8) return std::min<std::size_t>(begin + position.character, end);
  std::size_t at = begin;
  for (std::uint32_t units = 0; at < end && units < position.character;) {
    units += units_of(text_[at]);
    ++at;
    while (at < end && continues_character(text_[at])) ++at;
  }
  return at;
}

Position TextDocument::position_of(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const auto next = std::upper_bound(lines_.begin(), lines_.end(), offset);
  const auto line = static_cast<std::size_t>(next - lines_.begin()) - 1;
  const std::size_t begin = lines_[line], end = std::min(offset, std::max(end_of(line), begin));
  if (columns_ == Columns::utf8) return {static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(end - begin)};
  if (counted_.begin != begin || counted_.at > end) counted_ = {begin, begin, 0};
  for (; counted_.at < end; ++counted_.at)
    if (!continues_character(text_[counted_.at])) counted_.units += units_of(text_[counted_.at]);
  return {static_cast<std::uint32_t>(line), counted_.units};
}

std::size_t TextDocument::offset_in_run(std::uint32_t line, std::uint32_t column) const {
  if (line == 0) return 0;
  if (line > run_lines_.size()) return text_.size();
  const std::size_t end = line < run_lines_.size() ? run_lines_[line] : text_.size();
  return std::min(run_lines_[line - 1] + std::max(column, 1u) - 1, end);
}

std::uint32_t TextDocument::run_line_of(std::size_t offset) const {
  const auto next = std::upper_bound(run_lines_.begin(), run_lines_.end(), offset);
  return std::max(static_cast<std::uint32_t>(next - run_lines_.begin()), 1u);
}

std::string_view TextDocument::run_line(std::uint32_t line) const {
  const std::size_t begin = offset_in_run(line, 1);
  std::size_t end = line < run_lines_.size() ? run_lines_[line] : text_.size();
  while (end > begin && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
  return std::string_view(text_).substr(begin, end - begin);
}

}  // namespace isogloss::editors
