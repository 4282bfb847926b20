#include <algorithm>
#include <stdexcept>

#include "lsp/analysis.hpp"
#include "lsp/text_document.hpp"

namespace isogloss::editors {

namespace {

class Mapper {
 public:
  Mapper(const Setup& setup, const TextDocument& text, ScanMap& out)
      : layout_(setup.linked->layout), text_(text), out_(out) {}

  void add(const ScannedBlock& block) {
    base_ = text_.offset_in_run(block.line, block.column + 1);
    std::size_t word = 0;
    for (const ScannedPiece& piece : block.pieces) {
      std::uint32_t at = piece.begin;
      for (; word < block.words.size() && block.words[word].begin < piece.end; ++word) {
        const ScannedWord& w = block.words[word];
        if (w.begin < at) continue;
        add_text(block, piece, at, w.begin);
        push(w.begin, w.end, is_code(w.field) ? TokenKind::code : TokenKind::word, piece.reader + 1, w.field);
        at = w.end;
      }
      if (at < piece.end) add_text(block, piece, at, piece.end);
    }
    for (const ScannedLabel& label : block.labels)
      out_.labels.push_back(
          {label.name, label.is_program, base_ + label.begin, base_ + trimmed_end(block, label.end), block.line});
    if (!block.comment.empty()) out_.comments.push_back({std::string(block.comment), block.line});
  }

 private:
  bool is_code(ig_field f) const { return layout_.fields[f].type == IG_CODE; }

  static std::uint32_t trimmed_end(const ScannedBlock& block, std::uint32_t end) {
    while (end > 0 && (block.text[end - 1] == ' ' || block.text[end - 1] == '\t')) --end;
    return end;
  }

  TokenKind kind_of(const ScannedBlock& block, const ScannedPiece& piece) const {
    if (piece.reader + 1 == block.comment_reader) return TokenKind::comment;
    if (piece.reader + 1 == block.number_reader) return TokenKind::number;
    for (const ScannedLabel& label : block.labels)
      if (label.begin == piece.begin && label.end == piece.end) return TokenKind::label;
    return TokenKind::text;
  }

  void add_text(const ScannedBlock& block, const ScannedPiece& piece, std::uint32_t begin, std::uint32_t end) {
    const auto is_blank = [&](std::uint32_t i) { return block.text[i] == ' ' || block.text[i] == '\t'; };
    while (begin < end && is_blank(begin)) ++begin;
    while (begin < end && is_blank(end - 1)) --end;
    if (begin < end) push(begin, end, kind_of(block, piece), piece.reader + 1, IG_NO_FIELD);
  }

  void push(std::uint32_t begin, std::uint32_t end, TokenKind kind, std::uint32_t reader, ig_field field) {
    out_.tokens.push_back({base_ + begin, base_ + end, kind, reader, field});
  }

  const Layout& layout_;
  const TextDocument& text_;
  ScanMap& out_;
  std::size_t base_ = 0;
};

}  // namespace

std::pair<std::size_t, std::size_t> ScanMap::between(std::size_t begin, std::size_t end) const {
  const auto first = std::partition_point(tokens.begin(), tokens.end(), [&](const Token& t) { return t.end <= begin; });
  const auto last = std::partition_point(first, tokens.end(), [&](const Token& t) { return t.begin < end; });
  return {static_cast<std::size_t>(first - tokens.begin()), static_cast<std::size_t>(last - tokens.begin())};
}

ScanMap scan(const Setup& setup, const std::string& path, const TextDocument& text) {
  ScanMap out;
  Mapper mapper(setup, text, out);
  const std::unique_ptr<Source> source = memory_source(text.text());
  try {
    scan_blocks(*setup.linked, *source, path, setup.options, [&](const ScannedBlock& block) {
      mapper.add(block);
      return true;
    });
  } catch (const std::runtime_error&) {
    return out;  // the run reports what is wrong
  }
  return out;
}

}  // namespace isogloss::editors
