#include "reading/split_numbers.hpp"

#include <string>

namespace iso {

std::size_t join_split_word(ig::Block& b, std::string_view text, std::size_t position, const WordAddresses& addresses) {
  std::size_t before = position;
  while (before > 0 && is_blank(text[before - 1])) --before;
  std::size_t number = before;
  while (number > 0 && is_number_part(text[number - 1])) --number;
  std::size_t begin = number;
  while (begin > 0 && is_blank(text[begin - 1])) --begin;
  if (before == position || number == before || begin == 0 || !addresses.begins_word(text[begin - 1])) return position;
  if ((text[before - 1] == '.') == (text[position] == '.')) return position;
  --begin;
  const std::size_t end = skip_while(text, position, is_number_part);
  const std::string whole = std::string(piece(text, number, before)).append(piece(text, position, end));
  const ig::Decimal d = ig::read_decimal(whole, 0);
  const ig_field field = addresses[letter_index(text[begin])].field;
  ig_word word{};
  if (!d.ok || d.end != whole.size() || !b.has(field) || !b.word(field, word) || word.begin != column(begin))
    return position;
  word.value.number = d.value + 0.0;
  word.end = column(end);
  word.flags = 0;
  b.set_word(word);
  return end;
}

}  // namespace iso
