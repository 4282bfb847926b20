/// The words, ends and comments of macro statements.
#include "macro/macro_statement_text.hpp"

#include <array>

#include <isogloss/cnc/scan.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

struct Keyword {
  std::string_view name;
  Word word;
};
constexpr std::array keywords{
    Keyword{"IF", Word::if_},        Keyword{"THEN", Word::then},      Keyword{"WHILE", Word::while_},
    Keyword{"DO", Word::do_},        Keyword{"END", Word::end},        Keyword{"GOTO", Word::go_to},
    Keyword{"DPRNT", Word::output},  Keyword{"BPRNT", Word::output},   Keyword{"POPEN", Word::output},
    Keyword{"PCLOS", Word::output},  Keyword{"SETVN", Word::set_name}, Keyword{"ELSE", Word::foreign},
    Keyword{"ENDIF", Word::foreign}, Keyword{"RETURN", Word::foreign}, Keyword{"CALL", Word::foreign}};

/// Words that may be shortened to two letters or more, like functions.
constexpr std::array shortened_keywords{Keyword{"WHILE", Word::while_}, Keyword{"END", Word::end},
                                        Keyword{"THEN", Word::then},    Keyword{"GOTO", Word::go_to},
                                        Keyword{"DPRNT", Word::output}, Keyword{"BPRNT", Word::output},
                                        Keyword{"POPEN", Word::output}, Keyword{"PCLOS", Word::output}};

/// Whether the text after a shortened word at the beginning of a block fits it; more letters there are a typing error.
/// GO1 is not such a word, but G01 with a letter for its zero.
bool is_short_statement(std::string_view text, Word word, std::size_t end) {
  const char next = at(text, skip_blanks(text, end));
  if (word == Word::end) return is_digit(next);
  if (word == Word::while_ || word == Word::output) return next == '[';
  return false;
}

/// statement_end() for a block with parentheses.
std::size_t end_with_comments(std::string_view block, std::size_t position, bool& inner) {
  std::size_t end = position + 1;
  bool behind_comment = false;
  for (std::size_t i = position; i < block.size();) {
    if (block[i] == '(') {
      const std::size_t close = skip_bracketed(block, i);
      if (!behind_comment && has_message(piece(block, position, i)))
        end = close;
      else
        behind_comment = true;
      i = close;
      continue;
    }
    if (!is_blank(block[i])) {
      end = i + 1;
      inner |= behind_comment;
    }
    ++i;
  }
  return end;
}

}  // namespace

Word keyword(std::string_view text, std::size_t position, std::size_t& end) {
  end = skip_name_of(text, position, is_letter);
  const std::string_view word = piece(text, position, end);
  for (const Keyword& k : keywords)
    if (equals_ignoring_case(word, k.name)) return k.word;
  return Word::none;
}

Word keyword_or_short(std::string_view text, std::size_t position, std::size_t& end) {
  const Word whole = keyword(text, position, end);
  if (whole != Word::none || end < position + 2) return whole;
  const std::string_view word = piece(text, position, end);
  for (const Keyword& k : shortened_keywords)
    if (equals_ignoring_case(word, k.name.substr(0, word.size()))) return k.word;
  return Word::none;
}

Word statement_at(std::string_view text, std::size_t position) {
  const char c = text[position];
  if (c == '#') return Word::set_name;  // any statement of its own
  const char second = at(text, position + 1);
  if (to_upper(c) == 'O' && !is_letter(second))
    return begins_o_word(text, position) && stands_first(text, position) ? Word::foreign : Word::none;
  if (!is_letter(second)) return Word::none;
  std::size_t end = 0;
  const Word word = keyword(text, position, end);
  if (word == Word::none) {
    if (end < position + 2 || !stands_first(text, position)) return word;
    const Word meant = keyword_or_short(text, position, end);
    return is_short_statement(text, meant, end) ? meant : Word::none;
  }
  if (stands_first(text, position)) return word;
  const char next = at(text, skip_blanks(text, end));  // a name after words: a statement only with its value
  return next == '[' || next == '#' || is_digit(next) ? word : Word::none;
}

bool has_message(std::string_view statement) {
  return statement.find("#3000") != std::string_view::npos || statement.find("#3006") != std::string_view::npos;
}

std::size_t statement_end(std::string_view text, std::size_t position, bool& inner) {
  std::size_t end = skip_while(text, position, [](char c) { return c != ';' && c != '\r' && c != '\n' && c != '('; });
  if (at(text, end) == '(') {
    const std::size_t block = skip_while(text, end, [](char c) { return c != ';' && c != '\r' && c != '\n'; });
    return end_with_comments(text.substr(0, block), position, inner);
  }
  while (end > position + 1 && is_blank(text[end - 1])) --end;
  return end;
}

std::size_t words_behind_then(std::string_view text, std::size_t position, std::size_t end) {
  const std::string_view statement = text.substr(0, end);
  for (std::size_t i = position + 2; i < end;) {
    if (statement[i] == '[') {
      i = skip_bracketed(statement, i);
      continue;
    }
    std::size_t word_end = 0;
    if (is_letter(statement[i]) && keyword_or_short(statement, i, word_end) == Word::then) {
      const std::size_t next = skip_blanks(statement, word_end);
      if (next >= end || statement[next] == '#') return 0;
      std::size_t unused = 0;
      return is_letter(statement[next]) && keyword(statement, next, unused) == Word::none ? next : 0;
    }
    i = is_letter(statement[i]) ? skip_while(statement, i, is_letter) : i + 1;
  }
  return 0;
}

std::size_t governed(std::string_view text, std::size_t position, std::size_t end) {
  const std::string_view statement = text.substr(0, end);
  const std::size_t bracket = skip_blanks(statement, skip_while(statement, position, is_letter));
  if (at(statement, bracket) != '[') return 0;
  std::size_t rest = skip_blanks(statement, skip_bracketed(statement, bracket));
  std::size_t word_end = 0;
  if (is_letter(at(statement, rest)) && keyword_or_short(statement, rest, word_end) == Word::then)
    rest = skip_blanks(statement, word_end);
  if (at(statement, rest) == '#') return rest;
  const bool is_words = is_letter(at(statement, rest)) && keyword_or_short(statement, rest, word_end) == Word::none;
  return is_words ? rest : 0;
}

std::size_t assignment_end(std::string_view text, std::size_t position, std::size_t end) {
  const std::string_view statement = text.substr(0, end);
  for (std::size_t i = position; i < end;) {
    if (statement[i] == '[' || statement[i] == '(') {
      i = skip_bracketed(statement, i);
    } else if (is_letter(statement[i])) {
      const std::size_t letters = skip_while(statement, i, is_letter);
      if (letters == i + 1) return i;
      i = letters;
    } else {
      ++i;
    }
  }
  return end;
}

std::size_t return_end(std::string_view text, std::size_t position) {
  if (to_upper(at(text, position)) != 'M') return 0;
  const std::size_t digits = skip_blanks(text, position + 1);
  const std::size_t end = skip_digits(text, digits);
  return piece(text, digits, end) == "99" ? skip_blanks(text, end) : 0;
}

bool loop_number(std::string_view text, std::size_t position, std::int64_t& number) {
  const std::size_t digits = skip_blanks(text, position);
  const std::size_t end = skip_digits(text, digits);
  if (end == digits || end - digits > 9) return false;
  number = 0;
  for (std::size_t i = digits; i < end; ++i) number = number * 10 + (text[i] - '0');
  return true;
}

}  // namespace fanuc
