/// Operands of an expression: numbers, brackets and variables.
#include "macro/expression_reader.hpp"

#include <isogloss/number.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace detail {

Outcome ExpressionReader::expression() {
  MacroValue value;
  comparison(value);
  return outcome(value);
}

Outcome ExpressionReader::operand() {
  MacroValue value;
  primary(value);
  return outcome(value);
}

Outcome ExpressionReader::reference() {
  MacroValue number;
  skip_spaces();
  const std::size_t begin = position_;
  if (peek() != '#') {
    fail(Fault::no_operand, begin, begin + 1);
  } else {
    variable_number(number);
  }
  return outcome(number);
}

bool ExpressionReader::signed_operand(MacroValue& out) {
  bool negative = false, is_signed = false;
  std::size_t begin = position_;
  for (skip_spaces();; ++position_, skip_spaces()) {
    const char c = peek();
    if (c != '+' && c != '-') break;
    if (!is_signed) begin = position_;
    is_signed = true;
    negative ^= c == '-';
  }
  if (!primary(out)) return false;
  if (!is_signed) return true;
  if (!as_number(out, begin)) return false;
  out = {(negative ? -out.number : out.number) + 0.0, Kind::number};
  return true;
}

bool ExpressionReader::primary(MacroValue& out) {
  skip_spaces();
  const std::size_t begin = position_;
  const char c = peek();
  if (c == '#') return variable(out);
  if (c == '[') return bracket(out);
  if (is_number_start(c)) return number(out);
  if (is_name(c)) return function(out);
  return fail(Fault::no_operand, begin, begin + 1);
}

bool ExpressionReader::number(MacroValue& out) {
  const std::size_t begin = position_;
  const ig::Decimal d = ig::read_decimal(text_, begin);
  if (!d.ok) {
    return d.end == begin ? fail(Fault::no_operand, begin, begin + 1) : fail(Fault::number_too_large, begin, d.end);
  }
  position_ = end_ = d.end;
  out = {d.value, Kind::number};
  return true;
}

bool ExpressionReader::close(std::size_t opened) {
  skip_spaces();
  if (peek() != ']') {
    // What stands there instead says more than the bracket, unless the text ends.
    if (position_ < text_.size() && peek() != '\r' && peek() != '\n')
      return fail(Fault::no_operand, position_, position_ + 1);
    return fail(Fault::not_closed, opened, opened + 1);
  }
  --depth_;
  end_ = ++position_;
  return true;
}

bool ExpressionReader::bracket(MacroValue& out) {
  const std::size_t opened = position_;
  return open() && comparison(out) && close(opened);
}

bool ExpressionReader::plain_number(std::uint32_t& out) {
  std::size_t i = position_;
  std::uint32_t number = 0;
  for (; i < text_.size() && i < position_ + longest_variable && text_[i] >= '0' && text_[i] <= '9'; ++i)
    number = number * 10 + static_cast<std::uint32_t>(text_[i] - '0');
  if (i == position_ || (i < text_.size() && is_number_start(text_[i]))) return false;
  position_ = end_ = i;
  out = number;
  return true;
}

bool ExpressionReader::variable_number(MacroValue& out) {
  const std::size_t hash = position_++;
  skip_spaces();
  if (std::uint32_t plain = 0; plain_number(plain)) {
    out = {static_cast<double>(plain), Kind::number};
    return true;
  }
  const char c = peek();
  if (c == '[') {
    if (!bracket(out) || !as_number(out, hash)) return false;
    if (out.is_null()) return fail(Fault::no_variable, hash, end_);
    const double whole = std::round(out.number);
    // Calculated numbers carry the noise of their last digits.
    if (std::abs(out.number - whole) > 1e-6) return fail(Fault::no_variable, hash, end_);
    out.number = whole;
  } else if (c == '#') {
    return fail(Fault::double_hash, hash, position_ + 1);
  } else if (c == '<' || c == '_') {
    return fail(Fault::named_variable, hash, position_ + 1);
  } else if (c == '-' || c == '+') {
    return fail(Fault::no_variable, hash, position_ + 1);
  } else if (!is_number_start(c)) {
    return fail(Fault::no_operand, position_, position_ + 1);
  } else if (!number(out)) {
    return false;
  }
  if (!(out.number >= 0 && out.number <= 999'999) || out.number != std::floor(out.number))
    return fail(Fault::no_variable, hash, end_);
  return true;
}

bool ExpressionReader::variable(MacroValue& out) {
  const std::size_t begin = position_;
  MacroValue number;
  if (!variable_number(number)) return false;
  const Fault fault = variables_.read(static_cast<std::uint32_t>(number.number), out);
  if (fault == Fault::none) return true;
  unread_ = static_cast<std::uint32_t>(number.number);
  return fail(fault, begin, end_);
}

}  // namespace detail

Outcome evaluate(std::string_view text, std::size_t position, const ExpressionRules& rules,
                 const VariableSource& variables) {
  return detail::ExpressionReader(text, position, rules, variables).expression();
}

Outcome evaluate_operand(std::string_view text, std::size_t position, const ExpressionRules& rules,
                         const VariableSource& variables) {
  return detail::ExpressionReader(text, position, rules, variables).operand();
}

Outcome evaluate_reference(std::string_view text, std::size_t position, const ExpressionRules& rules,
                           const VariableSource& variables) {
  return detail::ExpressionReader(text, position, rules, variables).reference();
}

}  // namespace fanuc
