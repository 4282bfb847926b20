/// The text of files in MACRO format: where a statement ends, and what belongs to it. A statement ends with ; or, for
/// the openings of IF, FOR, WHILE and CASE, with their last word; it may reach over several lines, as a comment may.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace syntec {

enum class Keyword : std::uint8_t {
  none,  ///< words of a block
  assignment,
  function,  ///< ALARM( … ), and whatever else begins with a name
  case_label,
  if_,
  elseif,
  else_,
  end_if,
  case_,
  end_case,
  while_,
  end_while,
  for_,
  end_for,
  repeat,
  until,
  end_repeat,
  exit,
  go_to
};

Keyword keyword(std::string_view word);
/// IF, END_IF, … as the manual writes it.
std::string_view spelled(Keyword k);
/// The word that ends a statement in place of ; : THEN of IF. Empty: none does.
std::string_view closing_word(Keyword k);
/// ELSE, REPEAT and the ends stand alone.
bool stands_alone(Keyword k);

constexpr bool is_name_part(char c) { return ig::cnc::is_letter(c) || ig::cnc::is_digit(c) || c == '_'; }
constexpr std::size_t name_end(std::string_view text, std::size_t position) {
  return ig::cnc::skip_name_of(text, position, is_name_part);
}
/// Is the word, in any case, what stands at the position, as a whole?
bool is_word(std::string_view text, std::size_t position, std::string_view word);
/// The position of the word outside texts; the end of the text where it does not stand.
std::size_t find_word(std::string_view text, std::size_t position, std::string_view word);

/// The position of the ; that ends a block of words, or of the end of its line.
constexpr std::size_t words_end(std::string_view text, std::size_t position) {
  while (!ig::cnc::is_block_end(text, position) && text[position] != ';') ++position;
  return position;
}

/// Skips blanks, block skips, comments (* *) and sequence numbers from `begin` on. What is returned is less than `end`
/// where something else stands before it; it is more where one of them reaches beyond it.
std::size_t skip_head(std::string_view text, std::size_t begin, std::size_t end);

/// Which statement begins at the position, the first of its block.
Keyword statement_at(std::string_view text, std::size_t position);
/// The position behind 1, 2: of CASE; `position` where no such label stands there.
std::size_t label_end(std::string_view text, std::size_t position);

/// What scanners of one chain share.
struct MacroComment {
  bool is_open = false;    ///< (* of an earlier line has no *) yet
  std::uint32_t line = 0;  ///< where it stands
};

/// Collects the text of a statement.
class StatementCollector {
 public:
  /// Adds what belongs to the statement from `position` of a line on, and returns where it ends there. Blanks stand for
  /// comments and for what stands before, so that columns stay.
  std::size_t add(std::string_view line, std::size_t position, Keyword k, MacroComment& comment);
  void clear() {
    text_.clear();
    offset_ = begin_ = 0;
    is_complete_ = false;
  }
  bool is_begun() const { return !text_.empty() && !is_complete_; }
  bool is_complete() const { return is_complete_; }
  std::string_view text() const { return text_; }
  std::size_t offset() const { return offset_; }  ///< of the last line in the text
  std::size_t begin() const { return begin_; }    ///< of the statement in the text

 private:
  std::string text_;
  std::size_t offset_ = 0, begin_ = 0;
  bool is_complete_ = false;
};

}  // namespace syntec
