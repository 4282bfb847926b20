/// The lexical rules of Klartext: what separates words, where a statement ends, keywords, numbers with a comma.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <isogloss/cnc/scan.hpp>

namespace heidenhain {

using namespace ig::cnc;

/// A line that ends in ~ continues in the next one; the mark and the line end between them separate words.
constexpr bool is_space(char c) { return c == ' ' || c == '\t' || c == '~' || c == '\r' || c == '\n'; }
constexpr bool is_line_end(char c) { return c == '\r' || c == '\n'; }

constexpr std::size_t line_end(std::string_view text, std::size_t position) {
  return skip_while(text, position, [](char c) { return !is_line_end(c); });
}

/// The position after the comment at `position`. On a line that ~ adds, the comment continues, because it was too long
/// for its own line, unless the mark stands before the comment or the line is the next parameter of a cycle.
constexpr std::size_t comment_end(std::string_view text, std::size_t position) {
  const std::size_t end = line_end(text, position);
  if (end >= text.size()) return end;
  std::size_t before = position;
  while (before > 0 && is_blank(text[before - 1])) --before;
  if (before > 0 && text[before - 1] == '~') return end;
  const std::size_t q = skip_while(text, end, is_space);
  const std::size_t digits = to_upper(at(text, q)) == 'Q' ? skip_digits(text, q + 1) : q;
  const bool is_parameter = digits > q + 1 && at(text, skip_blanks(text, digits)) == '=';
  return is_parameter ? end : text.size();
}

/// The position of the next word of the statement: after blanks, and after a comment that the block continues behind. A
/// comment that ends the block is not skipped.
constexpr std::size_t skip(std::string_view text, std::size_t position) {
  while (position < text.size()) {
    if (is_space(text[position])) {
      ++position;
    } else if (text[position] == ';') {
      const std::size_t end = comment_end(text, position);
      if (end >= text.size()) return position;
      position = end;
    } else {
      break;
    }
  }
  return position;
}

/// True where the statement has no more text at this position.
constexpr bool is_end(std::string_view text, std::size_t position) {
  return position >= text.size() || text[position] == ';';
}

/// The end of the statement: the end of the block, or the comment that ends it. Text in quotes may hold a semicolon.
constexpr std::size_t statement_end(std::string_view text, std::size_t position) {
  if (text.find(';', position) == std::string_view::npos) return std::max(position, text.size());
  bool quoted = false;
  while (position < text.size()) {
    const char c = text[position];
    if (c == '"') quoted = !quoted;
    if (is_line_end(c)) quoted = false;
    if (c == ';' && !quoted) {
      const std::size_t next = skip(text, position);
      if (next == position) return position;
      position = next;
      continue;
    }
    ++position;
  }
  return position;
}

/// The position after the skip sign / or /1 to /9 at `position`. Before the block number a lone digit is the block
/// number itself, unless another number follows: /5 L, /3 12 L.
constexpr std::size_t skip_sign_end(std::string_view text, std::size_t position, bool before_number) {
  const char layer = at(text, position + 1);
  const bool is_layer = layer >= '1' && layer <= '9' && !is_digit(at(text, position + 2));
  if (!is_layer) return position + 1;
  return before_number && !is_digit(at(text, skip_blanks(text, position + 2))) ? position + 1 : position + 2;
}

/// The position where the words of the block begin: after its number, 12 or N12, and the skip sign.
constexpr std::size_t first_word(std::string_view text) {
  std::size_t i = skip_blanks(text, 0);
  if (at(text, i) == '/') i = skip_blanks(text, skip_sign_end(text, i, true));
  if (to_upper(at(text, i)) == 'N' && is_digit(at(text, i + 1))) ++i;
  i = skip_blanks(text, skip_digits(text, i));
  if (at(text, i) == '/') i = skip_blanks(text, skip_sign_end(text, i, false));
  return i;
}
constexpr bool stands_first(std::string_view text, std::size_t position) {
  const std::size_t digits = skip_digits(text, 0);
  const bool is_behind_number = digits > 0 && position == digits + 1 && text[digits] == ' ';  // 12 L, as nearly always
  return (is_behind_number && is_letter(at(text, position))) || position == first_word(text);
}

/// The position after the words of `upper`, each of which may be followed by blanks; `position` itself where they are
/// not there. No letter may follow the last word.
constexpr std::size_t keyword(std::string_view text, std::size_t position, std::string_view upper) {
  std::size_t i = position;
  for (const char c : upper) {
    if (c == ' ') {
      i = skip(text, i);
      continue;
    }
    if (to_upper(at(text, i)) != c) return position;
    ++i;
  }
  if (is_letter(upper.back()) && is_letter(at(text, i))) return position;
  return i;
}

/// The position after the letters of `upper`, which a sign, a number or a letter may follow directly; `position` itself
/// where they are not there.
constexpr std::size_t glued(std::string_view text, std::size_t position, std::string_view upper) {
  std::size_t end = position;
  for (const char c : upper) {
    if (to_upper(at(text, end)) != c) return position;
    ++end;
  }
  return end;
}

/// The same for a name before a value, which may be a Q parameter: LEN10, LEN +10, LENQ5. `position` also where the
/// letters go on otherwise: LENGTH.
constexpr std::size_t before_value(std::string_view text, std::size_t position, std::string_view upper) {
  const std::size_t end = glued(text, position, upper);
  const char next = to_upper(at(text, end));
  return is_letter(next) && next != 'Q' ? position : end;
}

/// The position after the letters at `position`.
constexpr std::size_t letters_end(std::string_view text, std::size_t position) {
  return skip_while(text, position, is_letter);
}

/// The position after the text at `position` that no blank and no comment divides.
constexpr std::size_t word_end(std::string_view text, std::size_t position) {
  return skip_while(text, position, [](char c) { return !is_space(c) && c != ';'; });
}

/// The text without blanks and line ends at both ends.
constexpr std::string_view trim(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// The text from a position to the end of its line, for a message.
constexpr std::string_view rest_of_line(std::string_view text, std::size_t position) {
  return trim(piece(text, position, line_end(text, position)));
}

/// An unsigned number at `position`, with a point or a comma before its fraction.
inline ig::Decimal read_number(std::string_view text, std::size_t position) {
  if (at(text, position) == '-' || at(text, position) == '+') return {.end = position};
  const ig::Decimal plain = ig::read_decimal(text, position);
  const std::size_t whole = plain.end;
  if (plain.has_point || at(text, whole) != ',') return plain;
  const std::size_t end = skip_digits(text, whole + 1);
  std::array<char, 64> copy{};
  if (end - position < copy.size()) {
    text.copy(copy.data(), end - position, position);
    copy[whole - position] = '.';
    ig::Decimal d = ig::read_decimal({copy.data(), end - position}, 0);
    d.end = d.end == 0 ? position : end;
    return d;
  }
  std::string longer(piece(text, position, end));
  longer[whole - position] = '.';
  ig::Decimal d = ig::read_decimal(longer, 0);
  d.end = end;
  return d;
}

/// The name of a label or program: a number, "a name", or letters and digits; upper case. Empty where there is none.
inline std::string read_name(std::string_view text, std::size_t position, std::size_t& end) {
  std::string name;
  if (at(text, position) == '"') {
    const std::size_t close = skip_while(text, position + 1, [](char c) { return c != '"' && !is_line_end(c); });
    name = trim(piece(text, position + 1, close));
    end = close < text.size() ? close + 1 : close;
  } else {
    end = word_end(text, position);
    name = piece(text, position, end);
  }
  for (char& c : name) c = to_upper(c);
  return name;
}

}  // namespace heidenhain
