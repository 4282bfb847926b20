/// The words that begin a statement of the program flow, and helpers to read its parts.
#pragma once

#include "language/siemens_expression.hpp"

namespace siemens {

using namespace ig::cnc;

enum class FlowWord : std::uint8_t {
  none,
  if_,
  else_,
  endif,
  while_,
  endwhile,
  for_,
  endfor,
  loop,
  endloop,
  repeat,
  repeatb,
  block,  ///< CALL BLOCK
  until,
  go,
  case_,
  ret
};

inline FlowWord flow_word(std::string_view name) {
  struct Known {
    std::string_view name;
    FlowWord word;
  };
  static constexpr Known known[] = {
      {"IF", FlowWord::if_},        {"ELSE", FlowWord::else_},        {"ENDIF", FlowWord::endif},
      {"WHILE", FlowWord::while_},  {"ENDWHILE", FlowWord::endwhile}, {"FOR", FlowWord::for_},
      {"ENDFOR", FlowWord::endfor}, {"LOOP", FlowWord::loop},         {"ENDLOOP", FlowWord::endloop},
      {"REPEAT", FlowWord::repeat}, {"REPEATB", FlowWord::repeatb},   {"UNTIL", FlowWord::until},
      {"GOTO", FlowWord::go},       {"GOTOF", FlowWord::go},          {"GOTOB", FlowWord::go},
      {"GOTOC", FlowWord::go},      {"GOTOS", FlowWord::go},          {"CASE", FlowWord::case_}};
  if (name.size() > 8 || name.size() < 2) return FlowWord::none;
  for (const Known& k : known)
    if (equals_ignoring_case(name, k.name)) return k.word;
  return FlowWord::none;
}

inline ig::Where columns(std::string_view text, std::size_t begin) {
  return ig::Where::columns(begin, std::max(text.size(), begin + 1));
}
/// True where the statement ends at `position`; false, with a diagnostic, where other text follows.
inline bool ends(ig::Block& b, std::string_view text, std::size_t position) {
  const std::size_t rest = skip_blanks(text, position);
  if (rest >= text.size()) return true;
  b.report(ig::diag("SIE-0141"), columns(text, rest), text.substr(rest));
  return false;
}
inline bool is_word(std::string_view text, std::size_t position, std::string_view word) {
  return equals_ignoring_case(piece(text, position, skip_name(text, position)), word);
}
/// The position of the word from `position` on, outside strings; the end of the text where it is not found.
inline std::size_t find_word(std::string_view text, std::size_t position, std::string_view word) {
  bool quoted = false;
  for (std::size_t i = position; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (!quoted && (i == 0 || !is_name_part(text[i - 1])) && is_word(text, i, word)) return i;
  }
  return text.size();
}
/// N0430 becomes the label N430.
inline void drop_zeros(std::string& label) {
  const bool is_number = label.size() > 1 && label[0] == 'N' && skip_digits(label, 1) == label.size();
  if (is_number) label.erase(1, std::min(label.find_first_not_of('0', 1), label.size() - 1) - 1);
}
/// True when a GOTO follows the condition.
inline bool has_jump(std::string_view text, std::size_t position) {
  const std::size_t end = statement_end(text, position);
  bool quoted = false;
  for (std::size_t i = position; i + 4 <= end; ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (!quoted && !is_name_part(text[i - 1]) && equals_ignoring_case(text.substr(i, 4), "GOTO")) return true;
  }
  return false;
}

/// The label of a block with a pattern of holes, at each of which MCALL calls a subprogram.
/// Without the zeros that std::to_string adds; for texts that explain.
inline std::string shown_number(double value) {
  std::string out = std::to_string(value);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.back() == '.') out.pop_back();
  return out;
}

inline std::string pattern_label(std::int64_t line) { return "PATTERN@" + std::to_string(line); }

}  // namespace siemens
