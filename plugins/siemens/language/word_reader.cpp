/// Words one after the other: which kind each is, and the words and codes that carry their number with them.
#include "language/word_reader.hpp"

#include <isogloss/cnc/program_name.hpp>

namespace siemens {

using namespace ig::cnc;

namespace {

constexpr bool is_number_part(char c) { return is_digit(c) || c == '.' || c == '+' || c == '-'; }
constexpr bool begins_number(char c) { return is_number_part(c); }

/// ID=1 and IDS=1 begin a synchronized action, which SiemensCallSyntax reports.
bool is_action_number(std::string_view text, std::size_t begin) {
  const std::size_t end = skip_short_name(text, begin);
  const std::string_view name = piece(text, begin, end);
  return (equals_ignoring_case(name, "ID") || equals_ignoring_case(name, "IDS")) &&
         at(text, skip_blanks(text, end)) == '=';
}

}  // namespace

std::size_t WordReader::scan(ig::Block& b, std::string_view text, std::size_t position) {
  if (other_meaning_.is_raised(b) && !b.is_in_turn()) return position;
  const char first = text[position];
  if (!is_name_start(first) && first != '$') return without_address(b, text, position);
  Run run;
  std::size_t next = position, end = position;
  do {
    const std::size_t behind = item(b, text, next, run);
    if (behind == next) break;  // for another scanner
    end = behind;
    next = skip_blanks(text, end);
  } while (next < text.size() && (is_name_start(text[next]) || text[next] == '$'));
  give(b, run);
  return end;
}

void WordReader::give(ig::Block& b, Run& run) const {
  if (defines_curve() && !ends_program(b, run)) run.count = 0;
  if (run.count > 0) b.set_words(run.words.data(), run.count);
  run.count = 0;
}

bool WordReader::ends_program(ig::Block& b, const Run& run) const {
  for (std::uint32_t i = 0; i < run.count; ++i)
    for (const std::uint32_t m : {2u, 17u, 30u})
      if (run.words[i].field == fields_.code('M', m)) {
        b.report(ig::diag("SIE-0320"), columns(run.words[i].begin, run.words[i].end),
                 static_cast<double>(environment_.store().curve_begins));
        environment_.store().curve_begins = 0;
        return true;
      }
  return false;
}

void WordReader::add(ig::Block& b, Run& run, ig_field field, std::size_t begin, std::size_t end, double value,
                     std::string_view name) const {
  if (run.count == run.words.size()) give(b, run);
  bool again = false;
  for (std::uint32_t i = 0; i < run.count; ++i) again = again || run.words[i].field == field;
  ig_value before;
  if (again || (begin > 0 && b.get(field, before))) {
    give(b, run);
    b.report(ig::diag("SIE-0122"), columns(begin, end), name);
    erase_mode(b, name);
  }
  run.words[run.count++] = {field, column(begin), column(end), {.number = value + 0.0}, 0, 0};
}

void WordReader::erase_mode(ig::Block& b, std::string_view name) const {
  const std::size_t word = AxisModes::index_of(environment_.axes.letter_of(name));
  if (const auto further = further_axis(name))
    b.erase(further_axes_.mode(*further));
  else if (word < AxisModes::words.size())
    modes_.erase(b, word);
}

std::size_t WordReader::plain_word(ig::Block& b, std::string_view text, std::size_t begin, Run& run) const {
  const char c = to_upper(text[begin]);
  if (!is_letter(c) || std::string_view("GLMNR").find(c) != std::string_view::npos) return begin;
  const ig::Decimal n = ig::read_decimal(text, begin + 1);
  if (!n.ok) return begin;
  const char behind = at(text, n.end);
  if (behind != '\0' && !is_blank(behind)) return begin;
  if (!n.has_point && at(text, skip_blanks(text, n.end)) == '=') return begin;
  word(b, run, std::string_view(&c, 1), fields_.letter(c), begin, n.end, n.value);
  return n.end;
}

std::size_t WordReader::item(ig::Block& b, std::string_view text, std::size_t begin, Run& run) {
  if (!environment_.has_macros())
    if (const std::size_t end = plain_word(b, text, begin, run); end != begin) return end;
  const char c = to_upper(text[begin]);
  const std::size_t second = begin + 1;
  const char d = at(text, second);
  if (environment_.has_macros() && !environment_.is_expanded() && c != '$' && !environment_.flow.is_indexing())
    if (const std::size_t end = skip_short_name(text, begin); at(text, skip_blanks(text, end)) != '=')
      if (const std::string* const macro = environment_.macro(b, upper(piece(text, begin, end))))
        return expand(b, text, begin, end, *macro, run);
  if (is_action_number(text, begin)) return begin;
  if (const std::size_t end = machine_name_end(b, text, begin); end != begin)
    return valued(b, text, begin, end, skip_blanks(text, end) + 1, run);
  if (c == '$' || c == '_' || is_name_start(d)) return named(b, text, begin, run);
  if (c == 'R' && (is_digit(d) || d == '[')) return assignment(b, text, begin, run);
  const std::size_t number = skip_blanks(text, second);
  const char v = at(text, number);
  if ((is_digit(d) || v == '=') && is_assigned_variable(b, text, begin)) return assignment(b, text, begin, run);
  if (v == '=' && at(text, number + 1) != '=') return valued(b, text, begin, second, number + 1, run);
  if (v == '[') return named(b, text, begin, run);
  if (!begins_number(v)) return empty_word(b, text, begin);
  if (c == 'G' || c == 'M') return code(b, text, begin, number, run);
  if (c == 'N' || (c == 'L' && is_digit(v))) return begin;
  const ig::Decimal n = ig::read_decimal(text, number);
  if (!n.ok) return refuse(b, ig::diag("SIE-0121"), text, begin, skip_while(text, number, is_number_part));
  std::size_t end = n.end;
  double value = n.value;
  if (const char behind = at(text, end); !(is_letter(behind) || is_blank(behind) || behind == '\0'))
    if (const std::size_t equals = skip_blanks(text, end); at(text, equals) == '=' && !n.has_point)
      return valued(b, text, begin, end, equals + 1, run);
  if (at(text, end) == '.' || at(text, end) == ',')
    return refuse(b, ig::diag("SIE-0123"), text, begin,
                  skip_while(text, end, [](char o) { return is_digit(o) || o == '.' || o == ','; }));
  if (const std::size_t equals = skip_blanks(text, end);
      !n.has_point && at(text, equals) == '=' && at(text, equals + 1) != '=')
    return valued(b, text, begin, end, equals + 1, run);
  if (equals_ignoring_case(text.substr(end, 2), "EX")) {
    Expression e(b, environment_, text, number);
    const auto computed = e.number();
    if (!computed) return std::max(e.position(), end);
    value = *computed;
    end = e.position();
  }
  word(b, run, std::string_view(&c, 1), fields_.letter(c), begin, end, value);
  return end;
}

void WordReader::word(ig::Block& b, Run& run, std::string_view name, ig_field field, std::size_t begin, std::size_t end,
                      double value) const {
  if (name.size() != 1 || axis_letters.find(name[0]) == std::string_view::npos)
    if (const auto axis = further_axis(name)) field = further_axes_.word(*axis).id();
  if (field == IG_NO_FIELD) {
    if (!defines_curve()) leave(b, IG_LEFT_WORD, name, begin, end);
  } else {
    add(b, run, field, begin, end, value, name);
  }
}

std::optional<std::uint32_t> WordReader::further_axis(std::string_view name) const {
  const auto axis = environment_.axes.find(name);
  return axis && is_further_axis(*axis) ? axis : std::nullopt;
}

std::size_t WordReader::code(ig::Block& b, std::string_view text, std::size_t begin, std::size_t number, Run& run) {
  const std::size_t end = skip_digits(text, number);
  const std::size_t equals = skip_blanks(text, end);
  if (at(text, equals) == '=' && at(text, equals + 1) != '=') return valued(b, text, begin, end, equals + 1, run);
  if (end == number || at(text, end) == '.')
    return refuse(b, ig::diag("SIE-0125"), text, begin, skip_while(text, number, is_number_part));
  std::uint32_t n = 0;
  for (std::size_t i = number; i < end && n < 100'000; ++i) n = n * 10 + static_cast<std::uint32_t>(text[i] - '0');
  set_code(b, run, to_upper(text[begin]), n, begin, end);
  return end;
}

void WordReader::set_code(ig::Block& b, Run& run, char letter, std::uint32_t n, std::size_t begin,
                          std::size_t end) const {
  const NumberedName name(letter, n);
  const ig_machine_code* row = machine_.find(name.text());
  if (row == nullptr && fields_.code(letter, n) == IG_NO_FIELD) row = machine_.family(name.text());
  if (row == nullptr) return set_known(b, run, letter, n, begin, end);
  if (!b.is_in_turn()) return;
  if (!environment_.flow.is_indexing() && !defines_curve()) record_.add(b, *row, columns(begin, end), name.text());
  for_each_code(*row, [&](std::string_view code) {
    if (const auto number = whole_number_of_code(code))
      set_known(b, run, code[0], *number, begin, end);
    else if (!defines_curve())
      leave(b, IG_LEFT_UNKNOWN, code, begin, end);
  });
}

void WordReader::set_known(ig::Block& b, Run& run, char letter, std::uint32_t n, std::size_t begin,
                           std::size_t end) const {
  const ig_field field = fields_.code(letter, n);
  if (field != IG_NO_FIELD) {
    if (run.count == run.words.size()) give(b, run);
    run.words[run.count++] = {field, column(begin), column(end), ig_value{}, 0, 0};
    return;
  }
  if (defines_curve()) return;
  std::array<char, 16> name{letter, '0'};
  const auto last = std::to_chars(name.data() + (n < 10 ? 2 : 1), name.data() + name.size(), n).ptr;
  leave(b, IG_LEFT_UNKNOWN, {name.data(), static_cast<std::size_t>(last - name.data())}, begin, end);
}

std::size_t WordReader::expand(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end,
                               const std::string& macro, Run& run) {
  const ExpandedText as(text, begin, end, macro);
  std::size_t next = skip_blanks(as.text(), begin);
  if (next >= as.macro_end() || (!is_name_start(as.text()[next]) && as.text()[next] != '$')) {
    b.report(ig::diag("SIE-0288"), ig::Where::columns(begin, end), std::string_view(macro));
    return end;
  }
  const std::size_t start = next;
  const Environment::Reading reading(environment_, as);
  while (next < as.macro_end()) {
    if (names_other_macro(as.text(), next, piece(text, begin, end))) {
      b.report(ig::diag("SIE-0288"), ig::Where::columns(begin, end), std::string_view(macro));
      return end;
    }
    const std::size_t first = run.count, behind = item(b, as.text(), next, run);
    if (behind == next) break;
    for (std::size_t i = std::min<std::size_t>(first, run.count); i < run.count; ++i) {
      run.words[i].begin = column(begin);
      run.words[i].end = column(end);
    }
    next = skip_blanks(as.text(), behind);
    if (next < as.macro_end() && !is_name_start(as.text()[next]) && as.text()[next] != '$') break;
  }
  if (next == start) return begin;
  if (next < as.macro_end()) {
    b.report(ig::diag("SIE-0288"), ig::Where::columns(begin, end), std::string_view(macro));
    return end;
  }
  return as.original(next);
}

std::size_t WordReader::empty_word(ig::Block& b, std::string_view text, std::size_t begin) const {
  return refuse(b, ig::diag("SIE-0121"), text, begin, begin + 1);
}

std::size_t WordReader::without_address(ig::Block& b, std::string_view text, std::size_t position) const {
  const std::size_t end = skip_while(text, position, [](char c) { return is_number_part(c) || c == ',' || c == '='; });
  if (piece(text, position, end).find_first_of("0123456789") == std::string_view::npos) {
    leave(b, IG_LEFT_TEXT, piece(text, position, end), position, end);
    return end;
  }
  return refuse(b, ig::diag("SIE-0115"), text, position, end);
}

}  // namespace siemens
