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
  // L, C and CC with their first word attached: LX+10, CCX+5, LIX+5
  for (const PathFunction f : {LP, LN, CC, CR, CT, CP, L, C}) {
    const std::size_t size = name_of(f).size();
    if (letters.size() <= size || letters.size() > size + 3 || !is_word) continue;
    if (equals_ignoring_case(letters.substr(0, size), name_of(f)) && is_axis_word(letters.substr(size)))
      return FoundPathFunction{f, position + size};
  }
  if (letters.size() == 1 && to_upper(letters[0]) == 'M' && is_digit(at(text, skip_blanks(text, end))))
    return FoundPathFunction{L, position};
  const bool has_value = is_word || to_upper(next) == 'Q' || (letters.size() > 1 && to_upper(letters.back()) == 'Q');
  const std::string_view axis =
      letters.size() > 1 && to_upper(letters.back()) == 'Q' ? letters.substr(0, letters.size() - 1) : letters;
  if (has_value && is_axis_word(axis)) return FoundPathFunction{L, position};
  return std::nullopt;
}

}  // namespace heidenhain
