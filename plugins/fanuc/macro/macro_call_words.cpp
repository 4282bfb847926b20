/// The words of a macro call.
#include "macro/macro_call_words.hpp"

#include <algorithm>

#include <isogloss/cnc/scan.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

/// The position after blanks and after comments that words follow; the end of the text where no word follows.
std::size_t next_call_word(std::string_view text, std::size_t position) {
  for (std::size_t i = position;;) {
    i = skip_blanks(text, i);
    const char c = at(text, i);
    if (c != '(') return i >= text.size() || c == ';' || c == '\r' || c == '\n' ? text.size() : i;
    i = skip_bracketed(text, i);
  }
}

}  // namespace

std::size_t MacroCallReader::read(std::size_t position, Names names) {
  std::size_t end = rest_ = position;
  for (std::size_t begin = position;;) {
    begin = next_call_word(text_, begin);
    const bool begins_comment = slashes_ == Slashes::comment && piece(text_, begin, begin + 2) == "//";
    if (begin >= text_.size() || begins_comment) return end;
    if (text_[begin] == '/') {
      if (skips(begin)) return end;
      rest_ = begin;
    } else {
      begin = end = rest_ = word(begin, names);
    }
  }
}

bool MacroCallReader::skips(std::size_t& begin) {
  const SkipSign sign = read_skip_sign(text_, begin);
  const std::size_t block = block_end(text_, sign.end);
  begin = sign.end;
  if (!block_skip_.skip(block_, sign.layer, piece(text_, sign.end, block))) return false;
  rest_ = block;
  return true;
}

std::size_t MacroCallReader::word(std::size_t begin, Names names) {
  const char letter = to_upper(text_[begin]);
  const unsigned index = letter_index(letter);
  const std::size_t at_value = skip_blanks(text_, begin + 1);
  const ig::Decimal literal = ig::read_decimal(text_, at_value);
  MacroValue value{literal.value, Kind::number};
  std::size_t end = literal.end;
  if (letter == '<' && names == Names::accepted) {
    end = skip_bracketed(text_, begin);
    if (end > begin + 2 && text_[end - 1] == '>') {
      out_.has_program = true;
      out_.name = piece(text_, begin, end);
      return end;
    }
  }
  if (index >= 26) {
    end = skip_while(text_, begin + 1, [](char c) { return !is_letter(c) && c != '(' && c != ';'; });
    return refuse(begin, end);
  }
  if (!literal.ok) {
    const std::optional<MacroValue> answer = computed(begin, at_value, end);
    if (!answer) return end;
    value = *answer;
  }
  const bool comes_in_sets = letter >= 'I' && letter <= 'K' && ijk_sets_ != IjkSets::one;
  if ((seen_ >> index & 1u) != 0 && !comes_in_sets)
    block_.report(ig::diag("FAN-0174"), ig::Where::columns(begin, end), std::string_view(&letter, 1));
  seen_ |= 1u << index;
  if (letter == 'P' || letter == 'L')
    set_program_or_repeats(letter, value);
  else if (variable_of[index] != 0)
    pass({letter, value, literal.ok && !literal.has_point, begin, end});
  else
    return refuse(begin, end);
  return end;
}

void MacroCallReader::set_program_or_repeats(char letter, const MacroValue& value) {
  if (value.is_null()) return;
  if (letter == 'L') {
    out_.repeats = value.number;
    return;
  }
  out_.has_program = true;
  out_.program = value.number;
  out_.name.clear();
}

void MacroCallReader::pass(const Argument& argument) {
  const auto [letter, value, without_point, begin, end] = argument;
  const std::uint32_t variable = variable_for(letter);
  if (variable > last_local) {
    block_.report(ig::diag("FAN-0164"), ig::Where::columns(begin, end), piece(text_, begin, end));
    return;
  }
  const double number = without_point ? units_.counted(block_, letter, value.number, begin, end) : value.number;
  out_.arguments[variable] = value.is_null() ? MacroStore::null : number + 0.0;
}

std::size_t MacroCallReader::refuse(std::size_t begin, std::size_t end) {
  end = std::max(end, begin + 1);
  block_.report(ig::diag("FAN-0163"), ig::Where::columns(begin, end), piece(text_, begin, end));
  return end;
}

/// I, J and K come in this order; a letter out of order begins the next set.
std::uint32_t MacroCallReader::variable_for(char letter) {
  const std::uint32_t first = variable_of[letter_index(letter)];
  if (letter < 'I' || letter > 'K' || ijk_sets_ == IjkSets::one) return first;
  if (letter <= last_of_set_) ++set_;
  last_of_set_ = letter;
  return first + 3 * set_;
}

std::optional<MacroValue> MacroCallReader::computed(std::size_t begin, std::size_t position, std::size_t& end) {
  bool negative = false;
  for (char c = at(text_, position); c == '-' || c == '+' || is_blank(c); c = at(text_, ++position))
    negative ^= c == '-';
  const Outcome o = evaluate_operand(text_, position, environment_.rules(), environment_.reader(block_));
  if (!o.ok()) {
    environment_.report(block_, o, text_);
    end = std::max({skip_expression(text_, position), o.end, o.fault_end, begin + 1});
    return std::nullopt;
  }
  end = o.end;
  if (o.value.is_null()) return o.value;
  return MacroValue{negative ? -o.value.number : o.value.number, Kind::number};
}

}  // namespace fanuc
