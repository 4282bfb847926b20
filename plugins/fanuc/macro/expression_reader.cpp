/// Operators, brackets, numbers and variables of an expression.
#include "macro/expression_reader.hpp"

#include <isogloss/number.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace detail {
namespace {

bool to_bits(double value, std::int32_t& out) {
  const double whole = std::round(value);
  if (!(std::abs(whole) <= 2147483647.0)) return false;
  out = static_cast<std::int32_t>(whole);
  return true;
}

}  // namespace

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

bool ExpressionReader::accept(std::string_view name) {
  if (text_.size() - position_ < name.size() || !equals(text_.substr(position_, name.size()), name)) return false;
  position_ += name.size();
  return true;
}

ExpressionReader::Relation ExpressionReader::relation() {
  skip_spaces();
  switch (upper(peek())) {
    case 'E': return accept("EQ") ? Relation::eq : Relation::none;
    case 'N': return accept("NE") ? Relation::ne : Relation::none;
    case 'G': return accept("GT") ? Relation::gt : accept("GE") ? Relation::ge : Relation::none;
    case 'L': return accept("LT") ? Relation::lt : accept("LE") ? Relation::le : Relation::none;
    default: return Relation::none;
  }
}

bool ExpressionReader::holds(Relation relation, const MacroValue& a, const MacroValue& b) {
  const bool same = a.is_null() == b.is_null() && a.number == b.number;
  switch (relation) {
    case Relation::eq: return same;
    case Relation::ne: return !same;
    case Relation::gt: return a.number > b.number;
    case Relation::ge: return a.number >= b.number;
    case Relation::lt: return a.number < b.number;
    default: return a.number <= b.number;
  }
}

bool ExpressionReader::comparison(MacroValue& out) {
  const std::size_t begin = position_;
  if (!sum(out)) return false;
  for (;;) {
    const Relation which = relation();
    if (which == Relation::none) return true;
    if (!as_number(out, begin)) return false;
    skip_spaces();
    const std::size_t right_begin = position_;
    MacroValue right;
    if (!sum(right) || !as_number(right, right_begin)) return false;
    out = MacroValue::truth(holds(which, out, right));
  }
}

template <class Operation>
bool ExpressionReader::bits(MacroValue& out, std::size_t begin, Operation operation,
                            bool (ExpressionReader::*next)(MacroValue&)) {
  const std::size_t left_end = position_;
  skip_spaces();
  const std::size_t right_begin = position_;
  MacroValue right;
  if (!(this->*next)(right)) return false;
  if (out.kind == Kind::truth && right.kind == Kind::truth) {
    out.number = operation(static_cast<std::uint32_t>(out.number), static_cast<std::uint32_t>(right.number));
    return true;
  }
  if (!as_number(out, begin) || !as_number(right, right_begin)) return false;
  std::int32_t a = 0, b = 0;
  if (!to_bits(out.number, a)) return fail(Fault::no_bits, begin, left_end);
  if (!to_bits(right.number, b)) return fail(Fault::no_bits, right_begin, end_);
  const auto result =
      static_cast<std::int32_t>(operation(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)));
  out = {static_cast<double>(result), Kind::number};
  return true;
}

bool ExpressionReader::sum(MacroValue& out) {
  const std::size_t begin = position_;
  if (!product(out)) return false;
  for (;;) {
    skip_spaces();
    const char c = upper(peek());
    const std::size_t at = position_;
    if (c == '+' || c == '-') {
      ++position_;
      skip_spaces();
      const std::size_t right_begin = position_;
      MacroValue right;
      if (!product(right) || !as_number(out, begin) || !as_number(right, right_begin)) return false;
      if (!finish(c == '+' ? out.number + right.number : out.number - right.number, out, begin)) return false;
    } else if (c == 'O' && accept("OR")) {
      if (!bits(
              out, begin, [](std::uint32_t a, std::uint32_t b) { return a | b; }, &ExpressionReader::product))
        return false;
    } else if (c == 'X' && accept("XOR")) {
      if (!bits(
              out, begin, [](std::uint32_t a, std::uint32_t b) { return a ^ b; }, &ExpressionReader::product))
        return false;
    } else {
      position_ = at;
      return true;
    }
  }
}

bool ExpressionReader::product(MacroValue& out) {
  const std::size_t begin = position_;
  if (!signed_operand(out)) return false;
  for (;;) {
    skip_spaces();
    const char c = upper(peek());
    if (c == '*' || c == '/') {
      ++position_;
      skip_spaces();
      const std::size_t right_begin = position_;
      MacroValue right;
      if (!signed_operand(right) || !as_number(out, begin) || !as_number(right, right_begin)) return false;
      if (c == '/' && right.number == 0) return fail(Fault::division_by_zero, right_begin, end_);
      if (!finish(c == '*' ? out.number * right.number : out.number / right.number, out, begin)) return false;
    } else if (c == 'M' && accept("MOD")) {
      skip_spaces();
      const std::size_t right_begin = position_;
      MacroValue right;
      if (!signed_operand(right) || !as_number(out, begin) || !as_number(right, right_begin)) return false;
      const double a = rules_.whole_modulus ? std::round(out.number) : out.number;
      const double b = rules_.whole_modulus ? std::round(right.number) : right.number;
      if (b == 0) return fail(Fault::division_by_zero, right_begin, end_);
      if (!finish(std::fmod(a, b), out, begin)) return false;
    } else if (c == 'A' && accept("AND")) {
      if (!bits(
              out, begin, [](std::uint32_t a, std::uint32_t b) { return a & b; }, &ExpressionReader::signed_operand))
        return false;
    } else {
      return true;
    }
  }
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

bool ExpressionReader::variable_number(MacroValue& out) {
  const std::size_t hash = position_++;
  skip_spaces();
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
