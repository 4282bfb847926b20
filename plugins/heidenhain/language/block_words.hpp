/// What a scanner of Klartext makes of text: words and codes of the block, or a diagnostic for text that is neither.
/// Positions are byte offsets into the text of the block; a diagnostic points at the text up to the end of its line.
#pragma once

#include <isogloss/sdk.hpp>

#include "language/klartext_text.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// Writes a word with its value, or a code, at the columns from `begin` to `end`.
inline void put_word(ig::Block& b, ig_field field, std::size_t begin, std::size_t end, double value) {
  const ig_word word{field, column(begin), column(end), {.number = value}, 0, 0};
  b.set_word(word);
}
inline void put_code(ig::Block& b, ig_field field, std::size_t begin, std::size_t end) {
  const ig_word word{field, column(begin), column(end), ig_value{}, 0, 0};
  b.set_word(word);
}

/// The columns from `begin` to the end of its line, without blanks at the end.
inline ig::Where where_of_line(std::string_view text, std::size_t begin) {
  return ig::Where::columns(begin, begin + rest_of_line(text, begin).size());
}

/// HEI-0103: the text from `begin` on is not a word of the statement `of`.
inline void report_not_a_word(ig::Block& b, std::string_view text, std::size_t begin, std::string_view of) {
  b.report(ig::diag("HEI-0103"), where_of_line(text, begin), rest_of_line(text, begin), of);
}
/// HEI-0106: the text from `begin` to `end` repeats a word of the block.
inline void report_repeated(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end) {
  b.report(ig::diag("HEI-0106"), ig::Where::columns(begin, end), trim(piece(text, begin, end)));
}
/// HEI-0105: the text from `begin` on has no meaning after the statement `of`.
inline void report_without_meaning(ig::Block& b, std::string_view text, std::size_t begin, std::string_view of) {
  b.report(ig::diag("HEI-0105"), where_of_line(text, begin), rest_of_line(text, begin), of);
}
/// The same for what stands behind the last word of the statement, if anything does. The text ends with the statement.
inline void report_rest(ig::Block& b, std::string_view text, std::size_t position, std::string_view of) {
  if (const std::size_t rest = skip(text, position); rest < text.size()) report_without_meaning(b, text, rest, of);
}
/// HEI-0122: the statement that begins at `begin` is not executed; `effect` is what is missing from there on.
inline void report_not_executed(ig::Block& b, std::string_view text, std::size_t begin, std::string_view effect) {
  b.report(ig::diag("HEI-0122"), where_of_line(text, begin), rest_of_line(text, begin), effect);
}

}  // namespace heidenhain
