/// What scanners share: classes of characters, and functions that find the end of a part of a block. Positions are byte
/// offsets into the text, from 0.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// 0 to 25 for a letter of either case, a larger number for any other character.
constexpr unsigned letter_index(char c) { return (static_cast<unsigned char>(c) | 0x20u) - 'a'; }
constexpr bool is_letter(char c) { return letter_index(c) < 26; }
constexpr char to_upper(char c) { return is_letter(c) ? static_cast<char>(c & ~0x20) : c; }

/// The character at a position; NUL past the end, which belongs to no word.
constexpr char at(std::string_view text, std::size_t position) {
  return position < text.size() ? text[position] : '\0';
}

constexpr std::size_t skip_blanks(std::string_view text, std::size_t position) {
  while (position < text.size() && is_blank(text[position])) ++position;
  return position;
}

template <class Predicate>
constexpr std::size_t skip_while(std::string_view text, std::size_t position, Predicate predicate) {
  while (position < text.size() && predicate(text[position])) ++position;
  return position;
}

/// skip_while() for a name, of which 64 bytes are read at most: names are shorter, and a scanner that read a line of
/// letters to its end from each of its letters would take seconds.
template <class Predicate>
constexpr std::size_t skip_name_of(std::string_view text, std::size_t position, Predicate is_part) {
  constexpr std::size_t longest = 64;
  return skip_while(text.substr(0, std::min(text.size(), position + longest)), position, is_part);
}

/// The position where the block ends: at a line feed, or at a lone carriage return inside the text.
constexpr std::size_t block_end(std::string_view text, std::size_t position) {
  if (position >= text.size()) return position;
  const std::string_view line = text.substr(0, text.find('\n', position));
  return std::min(line.find('\r', position), line.size());
}

/// Does the block end at the position? block_end() would look through the rest of a long line for it.
constexpr bool is_block_end(std::string_view text, std::size_t position) {
  return position >= text.size() || text[position] == '\n' || text[position] == '\r';
}

constexpr std::size_t skip_digits(std::string_view text, std::size_t position) {
  if (!std::is_constant_evaluated() && std::endian::native == std::endian::little) {
    std::uint64_t bytes;
    if (ig::detail::read_eight(text, text.data() + position, bytes)) {
      const std::uint64_t other = ig::detail::first_other(ig::detail::digit_values(bytes));
      if (other != 0) return position + static_cast<std::size_t>(std::countr_zero(other) / 8);
    }
  }
  return skip_while(text, position, is_digit);
}

constexpr std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

constexpr std::string_view piece(std::string_view text, std::size_t begin, std::size_t end) {
  return text.substr(begin, end - begin);
}

/// A position as a column of ig_word, which has 16 bits; larger positions become 65535.
constexpr std::uint16_t column(std::size_t position) {
  return static_cast<std::uint16_t>(position < 65535 ? position : 65535);
}

/// Compares letters without case; `upper` must be in capitals.
constexpr bool equals_ignoring_case(std::string_view text, std::string_view upper) {
  if (text.size() != upper.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (to_upper(text[i]) != upper[i]) return false;
  return true;
}

inline std::string in_capitals(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = to_upper(c);
  return out;
}

/// True when only tape marks, block skips, comments and the sequence number stand before the position.
constexpr bool stands_first(std::string_view text, std::size_t position) {
  for (std::size_t i = 0; i < position;) {
    const char c = text[i];
    if (is_blank(c) || c == '%') {
      ++i;
    } else if (c == '/') {
      i += is_digit(at(text, i + 1)) ? 2 : 1;
    } else if (c == '(') {
      const std::size_t close = text.find(')', i);
      if (close == std::string_view::npos || close >= position) return false;
      i = close + 1;
    } else if (c == 'N' || c == 'n') {
      const std::size_t digits = skip_blanks(text, i + 1);
      i = skip_digits(text, digits);
      if (i == digits) return false;
    } else {
      return false;
    }
  }
  return true;
}

/// The position past the bracket that closes the one at `position` ('[', '(' or '<'); the end of the block where none
/// does.
constexpr std::size_t skip_bracketed(std::string_view text, std::size_t position) {
  const char open = text[position];
  const char close = open == '[' ? ']' : open == '(' ? ')' : '>';
  std::size_t depth = 0;
  std::size_t i = position;
  if (text.find(close, position) == std::string_view::npos) return block_end(text, position);
  for (; i < text.size() && text[i] != '\r' && text[i] != '\n'; ++i) {
    if (text[i] == open) ++depth;
    if (text[i] == close && --depth == 0) return i + 1;
  }
  return i;
}

/// The position past one operand of an expression: #1, #[…], #<name>, […], SIN[…], 12.5; `position` itself where there
/// is none.
constexpr std::size_t skip_operand(std::string_view text, std::size_t position) {
  std::size_t i = skip_while(text, position, [](char c) { return c == '+' || c == '-' || is_blank(c); });
  const std::size_t hashes = i;
  i = skip_while(text, i, [](char c) { return c == '#' || is_blank(c); });
  const char c = at(text, i);
  if (c == '[') return skip_bracketed(text, i);
  if (c == '<' && i > hashes) return skip_bracketed(text, i);
  if (is_digit(c) || c == '.') return skip_while(text, i, [](char d) { return is_digit(d) || d == '.'; });
  const std::size_t name = skip_name_of(text, i, is_letter);
  if (name > i && at(text, name) == '[') return skip_bracketed(text, name);
  return position;
}

/// The position past an expression that has no blanks between its operands: #1, -[#2+1.], SIN[#3]*2. `position` itself
/// where there is none.
constexpr std::size_t skip_expression(std::string_view text, std::size_t position) {
  std::size_t end = skip_operand(text, position);
  while (end != position) {
    const char c = at(text, end);
    if (c != '+' && c != '-' && c != '*') break;
    const std::size_t next = skip_operand(text, end + 1);
    if (next == end + 1) break;
    end = next;
  }
  return end;
}

/// Whether a scanner makes a leftover of a value that is an expression, or passes it by for another scanner.
enum class Expressions { leave, pass };

/// Adds a leftover with the name `name` for the columns from `begin` to `end`.
inline void leave(Block& b, ig_leftover_kind kind, std::string_view name, std::size_t begin, std::size_t end,
                  ig_field field = IG_NO_FIELD) {
  const ig_leftover left{kind, field, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
                         to_text(name)};
  b.host()->add_leftover(b.raw(), &left);
}

/// True when the O at `position` begins an O-word of LinuxCNC (user manual, "O Codes"): `o100 sub`, `o<name> call [1]`,
/// `o[#1] if [#2 GT 3]`.
constexpr bool begins_o_word(std::string_view text, std::size_t position) {
  std::size_t i = skip_blanks(text, position + 1);
  if (const char c = at(text, i); c == '<' || c == '[') {
    i = skip_bracketed(text, i);
  } else if (c == '#' || is_digit(c)) {
    i = skip_operand(text, i);
  } else {
    return false;
  }
  i = skip_blanks(text, i);
  const std::string_view word = piece(text, i, skip_while(text, i, is_letter));
  for (const std::string_view keyword : {"SUB", "ENDSUB", "CALL", "RETURN", "IF", "ELSEIF", "ELSE", "ENDIF", "WHILE",
                                         "ENDWHILE", "DO", "BREAK", "CONTINUE", "REPEAT", "ENDREPEAT"})
    if (equals_ignoring_case(word, keyword)) return true;
  return false;
}

}  // namespace ig::cnc
