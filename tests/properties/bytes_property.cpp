// No byte of a block is lost in silence.
#include <algorithm>
#include <cctype>

#include "property.hpp"
#include "running.hpp"

namespace isogloss::properties {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// True for each byte of the text that a diagnostic covers; one without columns covers its line.
std::vector<bool> reported_bytes(const std::string& text, const std::vector<Diagnostic>& diagnostics) {
  std::vector<std::size_t> lines{0, 0};
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') lines.push_back(i + 1);
  std::vector<bool> out(text.size() + 1);
  for (const Diagnostic& d : diagnostics) {
    if (d.where.line == 0 || d.where.line >= lines.size()) continue;
    const std::size_t begin = lines[d.where.line];
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const bool has_columns = d.where.column != 0 && d.end_column > d.where.column;
    const std::size_t first = has_columns ? begin + d.where.column - 1 : begin;
    const std::size_t last = has_columns ? begin + d.end_column - 1 : end;
    for (std::size_t i = first; i < std::min(last, text.size()); ++i) out[i] = true;
  }
  return out;
}

/// Where a word that no dialect knows may stand, or is not looked at: within a text or the name of a program, a cycle
/// or a macro; in output for a printer, which is reported once; behind a condition, where nothing is read when it does
/// not hold or names a variable that is reported already, as blocks that are jumped over are not read either; in
/// declarations for the control alone.
bool takes_any_text(std::string_view block) {
  constexpr std::string_view words[] = {"\"",     "'",      ":",   "PRNT", "POPEN", "PCLOS", "SETVN", "PGM",
                                        "DEFINE", "EXTERN", "MSG", "IF",   "CALL",  "[",     "LBL",   "UNTIL"};
  std::string upper(block);
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  // Behind "10.0" and "200" follows the name; of 14, 20, 30 and 32 nothing is read.
  if (const std::size_t cycle = upper.find("CYCL DEF "); cycle != std::string::npos) {
    const std::size_t number = cycle + 9, end = std::min(upper.find_first_not_of("0123456789", number), upper.size());
    const std::string name = upper.substr(number, end - number);
    constexpr std::string_view unread[] = {"14", "20", "30", "32"};
    if (upper.substr(end, 1) != "." || upper.substr(end, 2) == ".0") return true;
    if (std::find(std::begin(unread), std::end(unread), name) != std::end(unread)) return true;
  }
  return std::any_of(std::begin(words), std::end(words),
                     [&](std::string_view word) { return upper.find(word) != std::string::npos; });
}

}  // namespace

/// Each byte of an executed block belongs to a word, to what a scanner has read as a whole, to a comment, or to a
/// diagnostic.
Verdict judge_bytes(const Case& program) {
  const std::string text = program.text();
  const Outcome outcome = run_text(program, text);
  const std::vector<bool> reported = reported_bytes(text, outcome.diagnostics);
  Verdict out;
  for (const Block& block : blocks_of(program, text)) {
    if (!outcome.executed.contains({block.line, block.column})) continue;
    std::vector<bool> owned(block.end - block.begin);
    const auto own = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) owned[i - block.begin] = true;
    };
    for (const auto& [begin, end] : block.words) own(begin, end);
    for (const Block::Piece& piece : block.pieces) own(piece.begin, piece.end);
    for (std::size_t i = block.begin; i < block.end; ++i) {
      if (is_blank(text[i])) continue;
      out.was_tried = true;
      if (owned[i - block.begin] || reported[i]) continue;
      out.fault = "line " + std::to_string(block.line) + ": nothing has read '" + text.substr(i, block.end - i) +
                  "', and no diagnostic tells of it";
      return out;
    }
  }
  return out;
}

/// A word that no dialect knows, put between two words of an executed block, is reported or changes a motion.
Verdict judge_foreign_words(const Case& program) {
  constexpr const char* words[] = {"?", "Q7X", "@1", "$", "W7W", "&", "\x07", "!", "E-", "WW"};
  const std::string text = program.text();
  const Outcome before = run_text(program, text);
  Verdict out;
  // Statements of Syntec's MACRO format are reported where they end, which may be lines later.
  const bool is_macro = text.find("%@MACRO") != std::string::npos;
  bool is_curve = false;  // blocks that are points of a curve table
  for (const Block& block : blocks_of(program, text)) {
    if (!before.executed.contains({block.line, block.column}) || block.pieces.empty()) continue;
    const std::string_view line = std::string_view(text).substr(block.begin, block.end - block.begin);
    is_curve =
        (is_curve || line.find("CTABDEF") != std::string_view::npos) && line.find("CTABEND") == std::string_view::npos;
    if (is_curve) continue;
    const std::uint64_t choice = choice_at(program.seed, line, 0);
    if (choice % 4 != 0) continue;  // a run for each of them is what takes the time
    const Block::Piece& piece = block.pieces[(choice >> 8) % block.pieces.size()];
    // A scanner may read a statement together with the comment behind it.
    const bool has_comment = text.substr(piece.begin, piece.end - piece.begin).find(';') != std::string::npos;
    if (piece.is_comment || piece.is_label || has_comment || (is_macro && !piece.is_word)) continue;
    const std::string word = words[(choice >> 16) % std::size(words)];
    if (takes_any_text(line)) continue;
    const std::string changed = text.substr(0, piece.end) + " " + word + " " + text.substr(piece.end);
    const Outcome after = run_text(program, changed);
    if (!after.executed.contains({block.line, block.column})) continue;  // a jump leaves it out now
    out.was_tried = true;
    const auto last = block.line + static_cast<std::uint32_t>(std::count(line.begin(), line.end(), '\n'));
    const bool is_reported = std::any_of(after.diagnostics.begin(), after.diagnostics.end(), [&](const Diagnostic& d) {
      return d.where.line >= block.line && d.where.line <= last;
    });
    if (is_reported || after.motions != before.motions) continue;
    out.fault = "line " + std::to_string(block.line) + ": '" + word + "' behind '" +
                text.substr(piece.begin, piece.end - piece.begin) + "' is neither reported nor changes a motion";
    return out;
  }
  return out;
}

}  // namespace isogloss::properties
