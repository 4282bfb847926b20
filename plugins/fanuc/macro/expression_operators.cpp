/// Operators of an expression: comparisons, sums, products, and AND, OR and XOR.
#include "macro/expression_reader.hpp"

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

}  // namespace detail
}  // namespace fanuc
