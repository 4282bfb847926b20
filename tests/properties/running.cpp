#include "running.hpp"

#include <algorithm>

#include "isogloss/engine/exporter.hpp"
#include "isogloss/engine/scan.hpp"
#include "product.hpp"

namespace isogloss::properties {

namespace {

class PlacesOfBlocks : public Exporter {
 public:
  explicit PlacesOfBlocks(std::set<Place>& places) : places_(places) {}
  void begin(Document&, const SymbolTable&) override {}
  bool block(Document& document, const SymbolTable&) override {
    const std::string_view text = document.source.text;
    const auto ends = document.source.is_joined ? std::count(text.begin(), text.end(), '\n') : 0;
    for (std::uint32_t line = 0; line <= static_cast<std::uint32_t>(ends); ++line)
      places_.insert({document.source.line + line, line == 0 ? document.source.column : 0});
    return true;
  }
  bool end() override { return true; }

 private:
  std::set<Place>& places_;
};

std::vector<std::size_t> beginnings_of_lines(std::string_view text) {
  std::vector<std::size_t> out{0, 0};  // line 0 is none
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') out.push_back(i + 1);
  return out;
}

/// A scanner may read many words in one go: where nothing stands between them but blanks, each is a piece.
std::vector<Block::Piece> split(const Block::Piece& piece, const Block& block, std::string_view text) {
  std::vector<Block::Piece> out;
  std::size_t at = piece.begin;
  const auto are_blanks = [&](std::size_t begin, std::size_t end) {
    return begin <= end && text.substr(begin, end - begin).find_first_not_of(" \t") == std::string_view::npos;
  };
  for (const auto& [begin, end] : block.words) {
    if (begin < piece.begin || end > piece.end) continue;
    if (!are_blanks(at, begin)) return {piece};
    out.push_back({begin, end, true, piece.is_comment, piece.is_number, piece.is_label});
    at = end;
  }
  if (!are_blanks(at, piece.end)) return {piece};
  return out;
}

}  // namespace

RunOptions options_of(const Case& program) {
  RunOptions out;
  out.chain.assignments = program.assignments();
  out.maximum_blocks = 2'000;
  out.maximum_motions = 20'000;
  out.maximum_jumps = out.maximum_loop_blocks = out.maximum_repeat_blocks = 2'000;
  out.maximum_depth = 20;
  return out;
}

Outcome run_text(const Case& program, const std::string& text) {
  Outcome out;
  RunOptions options = options_of(program);
  options.moved = [&](const FlowStep&) { out.has_jumps = true; };
  product::TextOutput lines;
  const auto motions = make_motion_exporter(lines, {Format::csv, false, true, true, {}});
  PlacesOfBlocks blocks(out.executed);
  DiagnosticList said;
  const std::unique_ptr<Source> source = memory_source(text);
  run(product::dialect(program.dialect), *source, "program", options, {motions.get(), &blocks}, said);
  out.motions = std::move(lines.text);
  out.diagnostics = std::move(said.all);
  return out;
}

std::vector<Block> blocks_of(const Case& program, const std::string& text) {
  const std::vector<std::size_t> lines = beginnings_of_lines(text);
  std::vector<Block> out;
  const auto visit = [&](const ScannedBlock& scanned) {
    const std::size_t at = lines[std::min<std::size_t>(scanned.line, lines.size() - 1)] + scanned.column;
    Block block{scanned.line, scanned.column, at, at + scanned.text.size(), {}, {}};
    for (const ScannedWord& word : scanned.words) block.words.emplace_back(at + word.begin, at + word.end);
    std::sort(block.words.begin(), block.words.end());
    for (const ScannedPiece& piece : scanned.pieces) {
      Block::Piece one{at + piece.begin, at + piece.end};
      one.is_comment = piece.reader + 1 == scanned.comment_reader;
      one.is_number = piece.reader + 1 == scanned.number_reader;
      for (const ScannedLabel& label : scanned.labels) one.is_label |= label.begin == piece.begin;
      const std::vector<Block::Piece> parts = split(one, block, text);
      block.pieces.insert(block.pieces.end(), parts.begin(), parts.end());
    }
    out.push_back(std::move(block));
    return true;
  };
  const std::unique_ptr<Source> source = memory_source(text);
  scan_blocks(product::dialect(program.dialect), *source, "program", options_of(program), visit);
  return out;
}

std::string shown(const Diagnostic& diagnostic) {
  return diagnostic.code + " at line " + std::to_string(diagnostic.where.line) + ": " + diagnostic.message;
}

}  // namespace isogloss::properties
