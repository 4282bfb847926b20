#include "reading/irregular_word.hpp"

#include "reading/split_numbers.hpp"

namespace iso {

namespace {

constexpr bool is_sign_or_blank(char c) { return c == '+' || c == '-' || is_blank(c); }
constexpr bool is_digit_or_o(char c) { return is_digit(c) || c == '.' || c == 'O' || c == 'o'; }

/// 1E5, 1e-3: an exponent follows its number without a blank and has no point. X1 E2.5 is two words.
std::size_t skip_exponent(std::string_view text, std::size_t position) {
  if (to_upper(at(text, position)) != 'E') return position;
  const char sign = at(text, position + 1);
  const std::size_t digits = position + (sign == '+' || sign == '-' ? 2 : 1);
  const std::size_t end = skip_digits(text, digits);
  return end == digits || at(text, end) == '.' ? position : end;
}

/// Skips CYCLE81(…) with its arguments, or TRANS X10, up to a comment: words after a name are not the block's own.
std::size_t skip_statement(std::string_view text, std::size_t position) {
  std::size_t end =
      skip_while(text, position, [](char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '.'; });
  if (at(text, end) == '(') end = skip_bracketed(text, end);
  end = skip_while(text, end, [](char c) { return c != '(' && c != ';' && c != '\r' && c != '\n'; });
  while (is_blank(text[end - 1])) --end;
  return end;
}

std::size_t refuse(ig::Block& b, ig::DiagnosticCode diagnostic, std::string_view text, std::size_t begin,
                   std::size_t end) {
  b.report(diagnostic, ig::Where::columns(begin, end), piece(text, begin, end));
  return end;
}

std::size_t leave_expression(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end, ig_field field,
                             std::size_t name_size = 1) {
  std::array<char, 16> name{};
  const std::size_t size = std::min(name_size, name.size());
  for (std::size_t i = 0; i < size; ++i) name[i] = to_upper(text[begin + i]);
  const std::string_view word = trim({name.data(), size});
  leave(b, IG_LEFT_EXPRESSION, word, begin, end, word.size() == 1 ? field : IG_NO_FIELD);
  return end;
}

/// X=#1, X1=10, R5=R2+1: the value reaches to the next blank outside brackets.
std::size_t leave_assignment(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                             ig_field field) {
  std::size_t end = skip_blanks(text, equals + 1);
  while (end < text.size() && std::string_view(" \t;\r\n").find(text[end]) == std::string_view::npos)
    end = text[end] == '[' || text[end] == '(' ? skip_bracketed(text, end) : end + 1;
  return leave_expression(b, text, begin, end, field, equals - begin);
}

}  // namespace

bool begins_expression(std::string_view text, std::size_t position) {
  const char c = at(text, position);
  return c == '#' || c == '[' || (is_letter(c) && at(text, skip_while(text, position, is_letter)) == '[');
}

std::size_t read_without_number(ig::Block& b, std::string_view text, std::size_t begin, std::size_t number,
                                ig_field field, Expressions expressions) {
  const char c = at(text, number);
  if (c == '=') return leave_assignment(b, text, begin, number, field);
  const bool is_signed = c == '+' || c == '-';
  const std::size_t body = is_signed ? skip_while(text, number, is_sign_or_blank) : number;
  if (begins_expression(text, body)) {
    if (expressions == Expressions::pass) return begin;
    return leave_expression(b, text, begin, skip_expression(text, number), field);
  }
  if (to_upper(c) == 'O' && is_digit(at(text, number + 1)))
    return refuse(b, ig::diag("ISO-0101"), text, begin, skip_while(text, number, is_digit_or_o));
  const std::size_t name = skip_while(text, begin, is_letter);
  if (name - begin > 2) return refuse(b, ig::diag("ISO-0110"), text, begin, skip_statement(text, name));
  if (is_number_part(c)) {
    const bool two_signs = is_signed && piece(text, number + 1, body).find_first_of("+-") != std::string_view::npos;
    return refuse(b, two_signs ? ig::diag("ISO-0105") : ig::diag("ISO-0116"), text, begin,
                  skip_while(text, body, is_number_part));
  }
  return refuse(b, ig::diag("ISO-0104"), text, begin, skip_while(text, begin + 1, [](char u) { return u == '_'; }));
}

std::size_t read_odd_end(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end, ig_field field) {
  const char c = text[end];
  const char after = at(text, end + 1);
  if (c == '.')
    return refuse(b, ig::diag("ISO-0103"), text, begin,
                  skip_while(text, end, [](char d) { return is_digit(d) || d == '.'; }));
  if (c == ',')
    return is_digit(after) ? refuse(b, ig::diag("ISO-0107"), text, begin, skip_digits(text, end + 1)) : begin;
  if (c == '=') return leave_assignment(b, text, begin, end, field);
  if (const std::size_t exponent = skip_exponent(text, end); exponent != end)
    return refuse(b, ig::diag("ISO-0106"), text, begin, exponent);
  if (to_upper(c) == 'O' && !is_letter(after))
    return refuse(b, ig::diag("ISO-0101"), text, begin, skip_while(text, end, is_digit_or_o));
  return begin;
}

std::size_t read_without_address(ig::Block& b, std::string_view text, std::size_t position) {
  const std::size_t end = skip_while(text, position, is_number_part);
  const std::string_view number = piece(text, position, end);
  if (number.find_first_of("0123456789") == std::string_view::npos) {
    leave(b, IG_LEFT_TEXT, number, position, end);
    return end;
  }
  return refuse(b, ig::diag("ISO-0109"), text, position, end);
}

std::size_t read_corner(ig::Block& b, std::string_view text, std::size_t position, Expressions expressions) {
  const std::size_t letter = skip_blanks(text, position + 1);
  if (!is_letter(at(text, letter))) return position;
  const std::size_t number = skip_blanks(text, letter + 1);
  const char c = to_upper(text[letter]);
  if (expressions == Expressions::pass && (c == 'C' || c == 'R') &&
      begins_expression(text, skip_while(text, number, is_sign_or_blank)))
    return position;
  const std::size_t end = skip_expression(text, number);
  const char name[2] = {',', c};
  leave(b, IG_LEFT_WORD, {name, 2}, position, end);
  return end;
}

}  // namespace iso
