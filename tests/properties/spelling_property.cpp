// Blanks, the order of words and the numbers of blocks change no motion, where the dialect leaves them free.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <map>
#include <set>
#include <span>

#include "property.hpp"
#include "running.hpp"

namespace isogloss::properties {

namespace {

enum class Messages : std::uint8_t { compared, left_out };

std::string without_blanks(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '\t') out += c;
  return out;
}

/// Without blanks. A long text is quoted in part, and its blanks decide how much of it: only its beginning is kept.
std::string comparable(std::string_view message) {
  constexpr std::size_t kept = 40;
  std::string out;
  std::size_t at = 0;
  while (at < message.size()) {
    const bool begins_quote = message[at] == '\'' && (at == 0 || message[at - 1] == ' ');
    const std::size_t end = begins_quote ? std::min(message.find('\'', at + 1), message.size() - 1) + 1 : at + 1;
    out += without_blanks(message.substr(at, end - at)).substr(0, kept);
    at = end;
  }
  return out;
}

/// What a run tells of its blocks, but for columns and blanks.
std::multiset<std::string> told(const Outcome& outcome, Messages messages) {
  std::multiset<std::string> out;
  for (const Diagnostic& d : outcome.diagnostics)
    out.insert(d.code + " line " + std::to_string(d.where.line) + " " +
               (messages == Messages::compared ? comparable(d.message) : std::string()));
  return out;
}

std::string line_at(std::string_view text, std::size_t at) {
  return std::string(text.substr(at, std::min(text.find('\n', at), text.size()) - at));
}

std::string first_difference(const std::string& before, const std::string& after) {
  std::size_t at = 0;
  while (at < std::min(before.size(), after.size()) && before[at] == after[at]) ++at;
  const std::size_t begin = at == 0 ? 0 : before.rfind('\n', at - 1) + 1;
  return "  before: " + line_at(before, std::min(begin, before.size())) +
         "\n  after:  " + line_at(after, std::min(begin, after.size())) + "\n";
}

/// The fault of a run whose text was changed in a way that must not matter; empty: there is none.
std::string fault_of(const Case& program, const std::string& text, const std::string& changed, Messages messages) {
  const Outcome before = run_text(program, text), after = run_text(program, changed);
  std::string out;
  if (before.motions != after.motions) out = "other motions:\n" + first_difference(before.motions, after.motions);
  const auto first = told(before, messages), second = told(after, messages);
  for (const std::string& one : first)
    if (first.count(one) != second.count(one)) out += "  only told before: " + one + "\n";
  for (const std::string& one : second)
    if (first.count(one) != second.count(one)) out += "  only told after: " + one + "\n";
  return out.empty() ? out : out + "the changed program:\n" + changed;
}

/// Changes of a text at places that its blocks give.
class Edits {
 public:
  void replace(std::size_t begin, std::size_t end, std::string by) { all_[begin] = {end, std::move(by)}; }
  bool is_empty() const { return all_.empty(); }
  std::string apply(const std::string& text) const {
    std::string out;
    std::size_t done = 0;
    for (const auto& [begin, edit] : all_) {
      out += text.substr(done, begin - done) + edit.second;
      done = edit.first;
    }
    return out + text.substr(done);
  }

 private:
  std::map<std::size_t, std::pair<std::size_t, std::string>> all_;
};

std::string_view text_of(const std::string& text, const Block::Piece& piece) {
  return std::string_view(text).substr(piece.begin, piece.end - piece.begin);
}

}  // namespace

namespace {

constexpr const char* wider[] = {" ", "  ", "\t", "   "};

/// Between the pieces of a block a gap may open, close or grow.
void change_gaps(const Case& program, const std::string& text, const Block& block, Edits& edits) {
  for (std::size_t i = 1; i < block.pieces.size(); ++i) {
    const Block::Piece &left = block.pieces[i - 1], &right = block.pieces[i];
    // What nothing has read may stand there, or the end of a line.
    if (text.substr(left.end, right.begin - left.end).find_first_not_of(" \t") != std::string::npos) continue;
    const std::uint64_t choice = choice_at(program.seed, text_of(text, right), i);
    const bool is_exponent = std::toupper(static_cast<unsigned char>(text[right.begin])) == 'E';
    const bool may_close = std::isalpha(static_cast<unsigned char>(text[right.begin])) != 0 && !is_exponent &&
                           left.is_word && right.is_word;
    if (may_close && choice % 3 == 0)
      edits.replace(left.end, right.begin, "");
    else if (choice % 3 != 2)
      edits.replace(left.end, right.begin, wider[(choice >> 8) % std::size(wider)]);
  }
}

/// Names end at blanks here: those that are there may grow, but for texts, comments and the names of programs.
void widen_blanks(const Case& program, const std::string& text, const Block& block, Edits& edits) {
  const std::string_view line = std::string_view(text).substr(block.begin, block.end - block.begin);
  if (line.find('"') != std::string_view::npos || line.find("PGM") != std::string_view::npos) return;
  const std::size_t end = std::min(text.find(';', block.begin), block.end);
  const auto may_grow = [&](std::size_t i) {
    return std::none_of(block.pieces.begin(), block.pieces.end(), [i](const Block::Piece& piece) {
      return (piece.is_comment || piece.is_label) && piece.begin <= i && i < piece.end;
    });
  };
  for (std::size_t i = block.begin + 1; i + 1 < end; ++i) {
    const std::uint64_t choice = choice_at(program.seed, line, i - block.begin);
    const bool is_alone = text[i] == ' ' && text[i - 1] != ' ' && text[i + 1] != ' ';
    if (is_alone && choice % 2 == 0 && may_grow(i)) edits.replace(i, i + 1, wider[(choice >> 8) % std::size(wider)]);
  }
}

}  // namespace

Verdict judge_blanks(const Case& program) {
  const std::string text = program.text();
  Edits edits;
  for (const Block& block : blocks_of(program, text))
    is_iso(program.dialect) ? change_gaps(program, text, block, edits) : widen_blanks(program, text, block, edits);
  if (edits.is_empty()) return {};
  return {true, fault_of(program, text, edits.apply(text), Messages::compared)};
}

namespace {

std::string upper_case(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return std::toupper(c); });
  return out;
}

std::string address_of(std::string_view word) {
  std::size_t end = 0;
  while (end < word.size() && std::isalpha(static_cast<unsigned char>(word[end])) != 0) ++end;
  return upper_case(word.substr(0, end));
}

bool is_code(const std::string& address) { return address == "G" || address == "M"; }

/// Whether the word is one of these codes, however it is written: G4, G04 or G4.0.
bool is_code_of(std::string_view word, char letter, std::span<const int> numbers) {
  if (word.empty() || std::toupper(static_cast<unsigned char>(word[0])) != letter) return false;
  const double number = std::strtod(std::string(word.substr(1)).c_str(), nullptr);
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

/// Codes whose words are those that follow them: a program call, a macro call, values for a table.
bool owns_what_follows(std::string_view word) {
  constexpr int g[] = {10, 65, 66, 67}, m[] = {97, 98, 99, 198};
  return is_code_of(word, 'G', g) || is_code_of(word, 'M', m);
}

/// Codes with words of their own, which another one of them may want, too: which of two gets a word depends on where it
/// stands.
bool has_own_words(std::string_view word) {
  constexpr int numbers[] = {4,  12, 13, 27, 28, 29, 30, 31, 36, 37, 45, 46, 47, 48, 50, 51,  52,  68,
                             73, 74, 76, 77, 81, 82, 83, 84, 85, 86, 87, 88, 89, 92, 93, 100, 101, 150};
  return is_code_of(word, 'G', numbers);
}

/// The places of the words that may change places; fewer than two: none may.
std::vector<std::size_t> free_words(const std::string& text, const Block& block) {
  std::vector<std::size_t> out;
  std::set<std::string> addresses;
  int owners = 0;
  for (std::size_t i = 0; i < block.pieces.size(); ++i) {
    const Block::Piece& piece = block.pieces[i];
    if (piece.is_number && i == 0) continue;
    if (piece.is_comment && i + 1 == block.pieces.size()) continue;
    const std::string address = address_of(text_of(text, piece));
    // A statement, a label or a comment in between belongs where it stands.
    if (!piece.is_word || address.empty() || owns_what_follows(text_of(text, piece))) return {};
    if (has_own_words(text_of(text, piece)) && ++owners > 1) return {};
    // Of words with one address the last one, or each in its order, counts.
    if (!is_code(address) && !addresses.insert(address).second) return {};
    out.push_back(i);
  }
  return out;
}

}  // namespace

Verdict judge_order(const Case& program) {
  if (!is_iso(program.dialect)) return {};
  const std::string text = program.text();
  Edits edits;
  for (const Block& block : blocks_of(program, text)) {
    const std::vector<std::size_t> places = free_words(text, block);
    if (places.size() < 2) continue;
    Random random(choice_at(program.seed, std::string_view(text).substr(block.begin, block.end - block.begin), 0));
    std::vector<std::size_t> order = places;
    for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
    // Codes keep their order: of two of one group the last one counts.
    std::vector<std::size_t> codes;
    for (const std::size_t i : order)
      if (is_code(address_of(text_of(text, block.pieces[i])))) codes.push_back(i);
    std::sort(codes.begin(), codes.end());
    std::size_t next = 0;
    for (std::size_t& i : order)
      if (is_code(address_of(text_of(text, block.pieces[i])))) i = codes[next++];
    for (std::size_t i = 0; i < places.size(); ++i)
      if (order[i] != places[i])
        edits.replace(block.pieces[places[i]].begin, block.pieces[places[i]].end,
                      std::string(text_of(text, block.pieces[order[i]])));
  }
  if (edits.is_empty()) return {};
  return {true, fault_of(program, text, edits.apply(text), Messages::left_out)};
}

namespace {

/// Words of programs that find blocks by their numbers.
constexpr const char* jumping[] = {"GO", "M97", "M98", "M99", "G65", "G66", "CALL", "REPEAT", "NLAP", "RTS"};

bool may_jump(const std::string& text) {
  const std::string upper = upper_case(text);
  return std::any_of(std::begin(jumping), std::end(jumping),
                     [&](const char* word) { return upper.find(word) != std::string::npos; });
}

}  // namespace

Verdict judge_numbers(const Case& program) {
  const std::string text = program.text();
  if (may_jump(text)) return {};
  Edits edits;
  std::uint32_t number = 0;
  for (const Block& block : blocks_of(program, text)) {
    if (block.pieces.empty()) continue;
    const Block::Piece& first = block.pieces[0];
    const std::string prefix = program.dialect == "heidenhain" ? "" : "N";
    const std::uint64_t choice =
        choice_at(program.seed, std::string_view(text).substr(block.begin, block.end - block.begin), 0);
    number += 10;
    // A number makes a block of a comment.
    const bool is_needed = std::all_of(block.pieces.begin() + 1, block.pieces.end(),
                                       [](const Block::Piece& piece) { return piece.is_comment; });
    if (first.is_number)
      edits.replace(first.begin, first.end, choice % 2 == 0 && !is_needed ? "" : prefix + std::to_string(number));
    else if (first.is_word && choice % 2 == 0)
      edits.replace(first.begin, first.begin, prefix + std::to_string(number) + " ");
  }
  if (edits.is_empty()) return {};
  return {true, fault_of(program, text, edits.apply(text), Messages::compared)};
}

}  // namespace isogloss::properties
