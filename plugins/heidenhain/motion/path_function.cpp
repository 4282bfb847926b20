#include "motion/path_function.hpp"

#include "language/klartext_text.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

/// X, IX
bool is_axis_word(std::string_view letters) {
  if (letters.size() == 2 && to_upper(letters[0]) == 'I') letters.remove_prefix(1);
  return letters.size() == 1 && std::string_view("XYZABCUVW").find(to_upper(letters[0])) != std::string_view::npos;
}

/// X of XQ3, XQL3, XQR3, of which these are the letters.
std::string_view without_parameter(std::string_view letters) {
  for (const std::string_view parameter : {"Q", "QL", "QR"})
    if (letters.size() > parameter.size() &&
        equals_ignoring_case(letters.substr(letters.size() - parameter.size()), parameter))
      return letters.substr(0, letters.size() - parameter.size());
  return letters;
}

}  // namespace

std::optional<FoundPathFunction> any_path_function_at(std::string_view text, std::size_t position) {
  using enum PathFunction;
  const std::size_t end = letters_end(text, position);
  const std::string_view letters = piece(text, position, end);
  const char next = at(text, end);
  const bool is_word = next == '+' || next == '-' || is_digit(next) || next == '.';
  for (std::size_t i = 0; i < path_function_names.size(); ++i) {
    const auto function = static_cast<PathFunction>(i);
    if (equals_ignoring_case(letters, path_function_names[i]) && (function != C || !is_word))
      return FoundPathFunction{function, end};
  }
  const std::string_view words = without_parameter(letters);
  // L, C and CC with their first word attached: LX+10, CCX+5, LIX+5, LXQ3
  for (const PathFunction f : {LP, LN, CC, CR, CT, CP, L, C}) {
    const std::size_t size = name_of(f).size();
    if (words.size() <= size || words.size() > size + 3 || !is_word) continue;
    if (equals_ignoring_case(words.substr(0, size), name_of(f)) && is_axis_word(words.substr(size)))
      return FoundPathFunction{f, position + size};
  }
  if (letters.size() == 1 && to_upper(letters[0]) == 'M' && is_digit(at(text, skip_blanks(text, end))))
    return FoundPathFunction{L, position};
  const bool has_value = is_word || to_upper(next) == 'Q' || words.size() < letters.size();
  if (has_value && is_axis_word(words)) return FoundPathFunction{L, position};
  return std::nullopt;
}

}  // namespace heidenhain
