#include "plain_block.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace isogloss::properties {

namespace {

const Codes modes{0,  1,    2,  3,    4,  17, 18, 19, 27, 28, 29, 30, 40,   41, 42, 43, 43.4, 44, 49, 50, 51, 52,
                  53, 53.1, 54, 54.1, 55, 56, 57, 58, 59, 61, 64, 68, 68.2, 69, 80, 90, 91,   92, 94, 95, 98, 99};
const Codes cycles{73, 74, 76, 81, 82, 83, 84, 85, 86, 87, 88, 89};
const Codes units{20, 21, 70, 71, 700, 710};

/// A letter and a decimal number, as "X-10.5".
std::optional<PlainWord> word_of(std::string_view text) {
  PlainWord out{0, 0, std::string(text)};
  if (text.size() < 2 || std::isalpha(static_cast<unsigned char>(text[0])) == 0) return {};
  out.address = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  text.remove_prefix(text[1] == '+' ? 2 : 1);
  const auto read = std::from_chars(text.data(), text.data() + text.size(), out.value, std::chars_format::fixed);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return {};
  return out;
}

bool is_known(const PlainBlock& block, const std::string& dialect) {
  constexpr std::string_view addresses = "NOGMXYZABCIJKRQFSTDHLP";
  for (const PlainWord& word : block.words)
    if (addresses.find(word.address) == std::string_view::npos) return false;
  for (const double code : block.codes)
    if (modes.count(code) == 0 && cycles.count(code) == 0) return false;
  // Words of an M code, such as the angle of M19 R, and axes that share a block with a dwell.
  if (block.has('M') && block.has_any_of("IJKQR")) return false;
  if (block.has_code({4}) && (block.codes.size() > 1 || block.has_any_of("YZIJKQRF"))) return false;
  // There, X beside a dwell is an axis, and G74 no cycle.
  if (dialect == "siemens" && (block.is_cycle() || (block.has_code({4}) && block.has('X')))) return false;
  // Scaling on the others.
  if (dialect == "okuma" && block.has_code({51})) return false;
  // Of a modal block, J may be the ratio of a tapping cycle.
  if (dialect == "haas" && block.has('J') && !block.is_cycle() && !block.is_arc()) return false;
  // K of a modal block is a centre or a number of holes.
  return !block.has('K') || block.is_cycle() || block.is_arc();
}

}  // namespace

bool PlainBlock::has_any_of(std::string_view addresses) const {
  return std::any_of(words.begin(), words.end(),
                     [=](const PlainWord& w) { return addresses.find(w.address) != std::string_view::npos; });
}

bool PlainBlock::has_code(const Codes& wanted) const {
  return std::any_of(wanted.begin(), wanted.end(), [&](double code) { return codes.count(code) != 0; });
}

bool PlainBlock::is_cycle() const { return has_code(cycles); }

const PlainWord* PlainBlock::word(char address) const {
  for (const PlainWord& word : words)
    if (word.address == address) return &word;
  return nullptr;
}

std::string PlainBlock::text() const {
  std::string out;
  for (const PlainWord& word : words) out += word.text;
  return out;
}

std::optional<PlainBlock> plain_block(const Case& program, const std::string& text, const Block& block) {
  PlainBlock out{block.line, {}, {}};
  for (const Block::Piece& piece : block.pieces) {
    if (piece.is_comment) continue;
    auto word = word_of(std::string_view(text).substr(piece.begin, piece.end - piece.begin));
    if (!word || (!piece.is_word && !piece.is_number)) return {};
    if (word->address == 'G') {
      if (units.count(word->value) != 0) continue;
      out.codes.insert(word->value);
    }
    out.words.push_back(std::move(*word));
  }
  if (!is_known(out, program.dialect)) return {};
  return out;
}

std::string decimal(double value) {
  char out[512];
  char* const end = std::to_chars(out, out + sizeof out, value, std::chars_format::fixed).ptr;
  std::string text(out, end);
  return text.find('.') == std::string::npos ? text + "." : text;
}

}  // namespace isogloss::properties
