#include "motion/corner_words.hpp"

namespace heidenhain {

using namespace ig::cnc;

Value CornerWords::size(ig::Block& b, const Values& values, std::string_view text, std::size_t position,
                        PathFunction function) const {
  std::size_t i = skip(text, position);
  if (function == PathFunction::RND && to_upper(at(text, i)) == 'R') i = skip(text, i + 1);
  return i < text.size() ? values.read(b, text, i) : Value{};
}

std::size_t CornerWords::feed(ig::Block& b, std::string_view text, std::size_t position, PathFunction function) const {
  std::size_t end = std::max(position + 1, word_end(text, position));
  if (end == position + 1) {
    const std::size_t value = skip_blanks(text, end);
    const char c = to_upper(at(text, value));
    const bool has_value = is_digit(c) || c == '.' || c == '+' || c == 'Q' || keyword(text, value, "MAX") != value ||
                           keyword(text, value, "AUTO") != value;
    if (!has_value) return end;
    end = word_end(text, value);
  }
  b.report(ig::diag("HEI-0181"), ig::Where::columns(position, end), piece(text, position, end), name_of(function));
  return end;
}

void CornerWords::set(ig::Block& b, PathFunction function, double size, ig::Where where) const {
  if (size < 0)
    b.report(ig::diag("HEI-0130"), where, name_of(function),
             std::string_view("it is less than 0, the corner stays sharp"));
  else if (size == 0)
    b.report(ig::diag("HEI-0105"), where, std::string_view("0"), name_of(function));
  else
    b.set(function == PathFunction::RND ? radius_ : chamfer_, size * unit_.in_mm(b));
}

}  // namespace heidenhain
