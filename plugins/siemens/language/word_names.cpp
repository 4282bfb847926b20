// Words whose address is a name: macros, axes as the machine calls them, variables and indexed names.
#include "language/word_reader.hpp"

namespace siemens {

bool WordReader::names_other_macro(std::string_view text, std::size_t position, std::string_view macro) const {
  const std::size_t end = skip_name(text, position);
  const std::string name = upper(piece(text, position, end));
  return skip_name(macro, 0) == macro.size() && at(text, skip_blanks(text, end)) != '=' &&
         !equals_ignoring_case(name, macro) && environment_.has_macro(name);
}

std::size_t WordReader::named(ig::Block& b, std::string_view text, std::size_t begin, Run& run) {
  if (text[begin] == '$') return assignment(b, text, begin, run);
  std::size_t end = skip_short_name(text, begin);
  const std::size_t behind = skip_blanks(text, end);
  if (at(text, behind) == '[') return assignment(b, text, begin, run);
  if (at(text, behind) == '=' && at(text, behind + 1) != '=') {
    if (environment_.flow.is_indexing()) return block_end(text, begin);
    const std::string name = upper(piece(text, begin, end));
    environment_.enter(b);
    const bool is_variable = environment_.store().find(name) != nullptr || environment_.store().given(name);
    const bool has_number = is_digit(name.back()) && is_letter(name[0]) && skip_digits(name, 1) == name.size();
    if (!is_variable && (name == "ID" || name == "IDS")) return begin;  // a synchronized action
    if (!is_variable && (fields_.address(name) != IG_NO_FIELD || has_number))
      return valued(b, text, begin, end, behind + 1, run);
    return assignment(b, text, begin, run);
  }
  if (at(text, behind) == '(' && equals_ignoring_case(piece(text, begin, end), "EXECSTRING"))
    return execute_string(b, text, begin, behind, run);
  const ig_field field = fields_.code(upper(piece(text, begin, end)));
  if (field == IG_NO_FIELD || at(text, behind) == '(') return begin;
  if (run.count == run.words.size()) give(b, run);
  run.words[run.count++] = {field, column(begin), column(end), ig_value{}, 0, 0};
  return end;
}

std::size_t WordReader::execute_string(ig::Block& b, std::string_view text, std::size_t begin, std::size_t open,
                                       Run& run) {
  const std::size_t end = skip_call(text, open);
  if (environment_.flow.is_indexing()) return end;
  Expression e(b, environment_, text, open + 1);
  const auto value = e.value();
  if (!value) return end;
  if (!value->is_text() || at(text, skip_blanks(text, e.position())) != ')' || environment_.is_expanded()) {
    b.report(ig::diag("SIE-0305"), columns(begin, end), trim(piece(text, open + 1, end - 1)));
    return end;
  }
  if (trim(value->text).empty()) return end;
  const std::size_t behind = expand(b, text, begin, end, value->text, run);
  if (behind != begin) return behind;
  b.report(ig::diag("SIE-0305"), columns(begin, end), std::string_view(value->text));
  return end;
}

std::size_t WordReader::machine_name_end(ig::Block& b, std::string_view text, std::size_t begin) const {
  const std::size_t end = skip_short_name(text, begin), equals = skip_blanks(text, end);
  if (end < begin + 2 || at(text, equals) != '=' || at(text, equals + 1) == '=') return begin;
  const std::string name = upper(piece(text, begin, end));
  if (!environment_.axes.find(name)) return begin;
  if (!environment_.flow.is_indexing()) environment_.enter(b);
  return environment_.flow.is_indexing() || environment_.store().find(name) == nullptr ? end : begin;
}

bool WordReader::is_assigned_variable(ig::Block& b, std::string_view text, std::size_t begin) const {
  const std::size_t end = skip_short_name(text, begin), equals = skip_blanks(text, end);
  if (at(text, equals) == '[') return true;  // X1[0]=5: no address with a number has an index
  if (at(text, equals) != '=' || at(text, equals + 1) == '=' || environment_.flow.is_indexing()) return false;
  if (!b.is_in_turn()) return true;  // what is defined is known in its turn
  environment_.enter(b);
  return environment_.store().find(upper(piece(text, begin, end))) != nullptr;
}

std::size_t WordReader::refuse(ig::Block& b, ig::DiagnosticCode diagnostic, std::string_view text, std::size_t begin,
                               std::size_t end) const {
  b.report(diagnostic, columns(begin, end), piece(text, begin, end));
  return end;
}

}  // namespace siemens
