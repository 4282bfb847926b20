/// Words with an equals sign: X=AC(10), CR=5, M1=3, T="DRILL". Their value is an expression.
#include "language/word_reader.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

/// T=2.19: the name of a tool, as tool managements have them, and no number.
bool is_with_point(std::string_view text, std::size_t begin, std::size_t end, double value) {
  const ig::Decimal n = ig::read_decimal(text, begin);
  return n.ok && n.has_point && skip_blanks(text, n.end) == skip_blanks(text, end) && value != std::floor(value);
}

bool is_r(std::string_view text, std::size_t begin, std::size_t end) {
  return to_upper(text[begin]) == 'R' && end > begin + 1 && skip_digits(text, begin + 1) == end;
}

}  // namespace

std::size_t WordReader::valued(ig::Block& b, std::string_view text, std::size_t begin, std::size_t name_end,
                               std::size_t equals, Run& run) {
  if (environment_.flow.is_indexing()) return block_end(text, begin);
  const std::string called = upper(trim(piece(text, begin, name_end)));
  const std::string name(environment_.axes.letter_of(called));
  const bool has_number = name.size() > 1 && skip_digits(name, 1) == name.size();
  const std::size_t value_at = skip_blanks(text, equals);
  if (name == "T" || name == "D") return tool(b, text, begin, value_at, run, name);
  if (name[0] == 'T' && has_number) return tool_of_spindle(b, text, begin, value_at, run, name.substr(1));
  const ig::Symbol mode = take_mode(b, text, value_at);
  Expression e(b, environment_, text, mode == ig::Symbol{} ? value_at : at_bracket_);
  const auto value = e.number();
  const std::size_t end = std::max(e.position(), equals);
  if (!value) return line_end_of_fault(text, end);
  if (name[0] == 'G' || name[0] == 'M' || name[0] == 'S' || name[0] == 'H')
    if (name.size() == 1 || has_number) return extended(b, text, begin, end, name, *value, run);
  word(b, run, called, fields_.address(name), begin, end, *value);
  if (mode != ig::Symbol{}) {
    const std::size_t word_index = AxisModes::index_of(name);
    if (const auto further = further_axis(name); further && !defines_curve())
      b.set(further_axes_.mode(*further), mode);
    else if (word_index < AxisModes::words.size())
      set_mode(b, word_index, mode);
    else if (!(name == "SPOS" || name == "SPOSA") || b.text(mode) == "IC")  // an angle, whichever way it is reached
      b.report(ig::diag("SIE-0128"), columns(begin, end), std::string_view(name), b.text(mode));
  }
  return end;
}

std::size_t WordReader::valued_as(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                                  const std::string& name, Run& run) {
  const Assigned a = assigned(b, text, equals);
  if (!a.value) return a.end;
  word(b, run, name, fields_.address(name), begin, a.end, *a.value);
  if (const auto further = further_axis(name); further && a.mode != ig::Symbol{} && !defines_curve())
    b.set(further_axes_.mode(*further), a.mode);
  else if (a.mode != ig::Symbol{} && AxisModes::index_of(name) < AxisModes::words.size())
    set_mode(b, AxisModes::index_of(name), a.mode);
  return a.end;
}

WordReader::Assigned WordReader::assigned(ig::Block& b, std::string_view text, std::size_t equals) {
  const std::size_t value_at = skip_blanks(text, equals + 1);
  const ig::Symbol mode = take_mode(b, text, value_at);
  Expression e(b, environment_, text, mode == ig::Symbol{} ? value_at : at_bracket_);
  const auto value = e.number();
  const std::size_t end = std::max(e.position(), equals + 1);
  return {value, mode, value ? end : line_end_of_fault(text, end)};
}

ig::Symbol WordReader::take_mode(ig::Block& b, std::string_view text, std::size_t position) {
  const std::size_t end = skip_name(text, position);
  const std::size_t open = skip_blanks(text, end);
  if (end == position || end - position > 3 || at(text, open) != '(') return {};
  for (const std::string_view mode : {"AC", "IC", "DC", "ACP", "ACN"})
    if (equals_ignoring_case(piece(text, position, end), mode)) {
      at_bracket_ = open;
      return b.symbol(mode);
    }
  return {};
}

std::size_t WordReader::line_end_of_fault(std::string_view text, std::size_t position) {
  for (std::size_t end = position;;) {
    while (end < text.size() && std::string_view(" \t;\r\n").find(text[end]) == std::string_view::npos)
      end = text[end] == '('   ? std::max(skip_call(text, end), end + 1)
            : text[end] == '"' ? std::min(text.find('"', end + 1), text.size() - 1) + 1
                               : end + 1;
    std::size_t next = skip_blanks(text, end);
    constexpr std::string_view joining = "+-*/<>";
    if (next >= text.size() || joining.find(text[next]) == std::string_view::npos) return end;
    while (next < text.size() && joining.find(text[next]) != std::string_view::npos) ++next;
    end = skip_blanks(text, next);
  }
}

std::size_t WordReader::extended(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end,
                                 const std::string& name, double value, Run& run) const {
  if (!b.is_in_turn() || defines_curve()) return end;
  const char letter = name[0];
  const bool is_master = name.size() == 1 || is_master_spindle(name.substr(1)) || (letter == 'M' && name == "M0");
  if (!is_master || letter == 'H') {
    b.report(ig::diag("SIE-0126"), columns(begin, end), trim(piece(text, begin, end)));
    return end;
  }
  if (letter == 'S') {
    word(b, run, "S", fields_.letter('S'), begin, end, value);
  } else if (value < 0 || value > 99'999 || value != std::floor(value) || (letter == 'G' && name.size() > 1)) {
    b.report(ig::diag("SIE-0125"), columns(begin, end), piece(text, begin, end));
  } else {
    set_code(b, run, letter, static_cast<std::uint32_t>(value), begin, end);
  }
  return end;
}

bool WordReader::is_master_spindle(std::string_view number) const {
  const auto named = environment_.store().master_spindle;
  return number == std::to_string(named.value_or(static_cast<std::int64_t>(master_)));
}

std::size_t WordReader::of_spindle(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                                   const std::string& indexed, Run& run) {
  if (!b.is_in_turn()) return begin;
  const std::size_t bracket = indexed.find('[');
  const std::string name = indexed.substr(0, bracket);
  const Assigned a = assigned(b, text, equals);
  if (!a.value) return a.end;
  if (is_master_spindle(std::string_view(indexed).substr(bracket + 1, indexed.size() - bracket - 2)))
    word(b, run, name, fields_.address(name), begin, a.end, *a.value);
  else
    b.report(ig::diag("SIE-0126"), columns(begin, a.end), piece(text, begin, a.end));
  return a.end;
}

std::string WordReader::extended_name(const std::string& indexed) const {
  const bool is_extended = indexed.size() > 3 && indexed[1] == '[' && indexed.back() == ']' &&
                           std::string_view("MSH").find(indexed[0]) != std::string_view::npos &&
                           skip_digits(indexed, 2) == indexed.size() - 1;
  if (!is_extended || environment_.store().find(indexed.substr(0, 1)) != nullptr) return {};
  return indexed[0] + indexed.substr(2, indexed.size() - 3);
}

std::size_t WordReader::tool_of_spindle(ig::Block& b, std::string_view text, std::size_t begin, std::size_t value_at,
                                        Run& run, const std::string& number) const {
  if (!b.is_in_turn()) return begin;
  if (is_master_spindle(number)) return tool(b, text, begin, value_at, run, "T");
  Expression e(b, environment_, text, value_at);
  if (!e.value()) return line_end_of_fault(text, std::max(e.position(), value_at));
  b.report(ig::diag("SIE-0126"), columns(begin, e.position()), trim(piece(text, begin, e.position())));
  return e.position();
}

std::size_t WordReader::tool(ig::Block& b, std::string_view text, std::size_t begin, std::size_t value_at, Run& run,
                             const std::string& name) const {
  if (!b.is_in_turn()) return begin;
  if (defines_curve()) return line_end_of_fault(text, value_at);
  const std::size_t end_of_name = skip_name(text, value_at);
  Expression e(b, environment_, text, value_at);
  // T=DRILL without quotes is written, too; the control reads a variable there.
  const bool is_bare_name =
      end_of_name > value_at && is_letter(text[value_at]) &&
      std::string_view("[(").find(at(text, skip_blanks(text, end_of_name))) == std::string_view::npos;
  if (is_bare_name && name == "T" && environment_.store().find(upper(piece(text, value_at, end_of_name))) == nullptr &&
      !is_r(text, value_at, end_of_name)) {
    b.report(ig::diag("SIE-0132"), columns(begin, end_of_name), piece(text, value_at, end_of_name));
    b.set_text(tool_name_, piece(text, value_at, end_of_name));
    return end_of_name;
  }
  const auto value = e.value();
  if (!value) return line_end_of_fault(text, std::max(e.position(), value_at));
  if (name == "T" && !value->is_text() && is_with_point(text, value_at, e.position(), value->number)) {
    const std::string_view number = trim(piece(text, value_at, e.position()));
    b.report(ig::diag("SIE-0132"), columns(begin, value_at + number.size()), number);
    b.set_text(tool_name_, number);
  } else if (!value->is_text())
    word(b, run, name, fields_.letter(name[0]), begin, e.position(), value->number);
  else if (name == "T")
    b.set_text(tool_name_, value->text);
  else
    b.report(ig::diag("SIE-0107"), columns(begin, e.position()), piece(text, begin, e.position()));
  return e.position();
}

}  // namespace siemens
