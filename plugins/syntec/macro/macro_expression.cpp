/// Operators, brackets, numbers, texts and variables.
#include "macro/macro_expression.hpp"

#include <charconv>
#include <cmath>

namespace syntec {

using ig::cnc::at;
using ig::cnc::is_digit;
using ig::cnc::is_letter;
using ig::cnc::skip_blanks;
using ig::cnc::to_upper;

std::nullopt_t MacroExpression::fail(ig::DiagnosticCode code, std::size_t begin, std::size_t end) {
  block_.report(code, text_.where(begin, end), piece(begin, end));
  return std::nullopt;
}

std::nullopt_t MacroExpression::unclosed(std::size_t begin) {
  return position_ < text_.text.size() ? fail_here() : fail(ig::diag("SYN-0022"), begin, text_.text.size());
}

std::string_view MacroExpression::piece(std::size_t begin, std::size_t end) const {
  constexpr std::size_t longest = 60;
  end = std::min(end, text_.text.size());
  if (begin >= end) return "the end of the statement";
  const std::string_view out = ig::cnc::trim(text_.text.substr(begin, std::min(end - begin, longest)));
  return out.empty() ? "the end of the statement" : out;
}

bool MacroExpression::accept(char c) {
  skip();
  if (here() != c) return false;
  ++position_;
  return true;
}

std::optional<double> MacroExpression::number() {
  const std::size_t begin = position_;
  const auto out = value();
  return out ? operand(*out, begin) : std::nullopt;
}

std::optional<bool> MacroExpression::truth() {
  const auto out = number();
  return out ? std::optional(*out != 0) : std::nullopt;
}

int MacroExpression::strength_of(Operator o) {
  constexpr int strengths[] = {-1, 0, 1, 2, 3, 4, 5, 5, 5, 5, 6, 6, 7, 7, 7};
  return strengths[static_cast<int>(o)];
}

MacroExpression::Operator MacroExpression::next_operator(std::size_t& behind) const {
  const std::string_view text = text_.text;
  const std::size_t begin = skip_blanks(text, position_);
  const char c = at(text, begin), next = at(text, begin + 1);
  const auto symbol = [&](Operator o, std::size_t size) {
    behind = begin + size;
    return o;
  };
  switch (c) {
    case '+': return symbol(Operator::add, 1);
    case '-': return symbol(Operator::subtract, 1);
    case '*': return symbol(Operator::multiply, 1);
    case '/': return next == '/' ? Operator::none : symbol(Operator::divide, 1);
    case '&': return symbol(Operator::and_, 1);
    case '=': return next == '=' ? Operator::none : symbol(Operator::equal, 1);
    case '<':
      return next == '>'   ? symbol(Operator::unequal, 2)
             : next == '=' ? symbol(Operator::less_or_equal, 2)
                           : symbol(Operator::less, 1);
    case '>': return next == '=' ? symbol(Operator::greater_or_equal, 2) : symbol(Operator::greater, 1);
    default: break;
  }
  if (!is_letter(c)) return Operator::none;
  const std::size_t end = ig::cnc::skip_name_of(text, begin, is_letter);
  const std::string_view word = text.substr(begin, end - begin);
  for (const auto& [name, o] : {std::pair{"MOD", Operator::modulo}, std::pair{"AND", Operator::and_},
                                std::pair{"XOR", Operator::xor_}, std::pair{"OR", Operator::or_}})
    if (ig::cnc::equals_ignoring_case(word, name)) {
      behind = end;
      return o;
    }
  return Operator::none;
}

std::optional<MacroValue> MacroExpression::binary(int weakest) {
  if (depth_ >= deepest) {
    block_.report(ig::diag("SYN-0023"), text_.from(position_), static_cast<double>(deepest));
    return std::nullopt;
  }
  ++depth_;
  const std::size_t begin = skip_blanks(text_.text, position_);
  auto left = unary();
  while (left) {
    std::size_t behind = 0;
    const Operator o = next_operator(behind);
    if (o == Operator::none || strength_of(o) < weakest) break;
    position_ = behind;
    const auto right = binary(strength_of(o) + 1);
    left = right ? apply(o, *left, *right, begin) : std::nullopt;
  }
  --depth_;
  return left;
}

std::optional<MacroValue> MacroExpression::unary() {
  bool is_negative = false;
  std::size_t complements = 0;
  for (;; ++position_) {
    skip();
    if (here() == '-')
      is_negative = !is_negative;
    else if (here() != '+')
      break;
  }
  const std::size_t begin = position_;
  const std::string_view text = text_.text;
  if (const std::size_t end = ig::cnc::skip_name_of(text, begin, is_letter);
      ig::cnc::equals_ignoring_case(text.substr(std::min(begin, text.size()), end - begin), "NOT")) {
    position_ = end;
    ++complements;
  }
  if (complements > 0) {
    if (depth_ >= deepest) {
      block_.report(ig::diag("SYN-0023"), text_.from(position_), static_cast<double>(deepest));
      return std::nullopt;
    }
    ++depth_;
    const auto inner = unary();
    --depth_;
    if (!inner) return std::nullopt;
    const auto number = whole_operand(*inner, "NOT", begin);
    if (!number) return std::nullopt;
    const double complement = -*number - 1;
    return whole_of(is_negative ? -complement : complement, begin);
  }
  // The sign belongs to a number: -2147483648 is an integer, 2147483648 is none.
  const bool is_hexadecimal = here() == '0' && to_upper(at(text, begin + 1)) == 'X';
  if (!is_hexadecimal && (is_digit(here()) || here() == '.')) return literal(is_negative);
  auto out = primary();
  if (!out || !is_negative || out->is_vacant()) return out;
  const auto number = operand(*out, begin);
  if (!number) return std::nullopt;
  return out->is_whole() ? whole_of(-*number, begin) : std::optional(MacroValue::real(0.0 - *number));
}

std::optional<MacroValue> MacroExpression::primary() {
  const std::size_t begin = position_;
  const char c = here();
  if (c == '(') {
    ++position_;
    auto out = binary(0);
    if (!out) return std::nullopt;
    if (!accept(')')) return unclosed(begin);
    return out;
  }
  if (c == '#' || c == '@') {
    const auto v = variable();
    if (!v) return std::nullopt;
    auto out = environment_.read(block_, *v, text_.where(begin, position_));
    if (out && out->is_vacant()) out->text = piece(begin, position_);
    return out;
  }
  if (c == '"') {
    const std::size_t close = text_.text.find('"', position_ + 1);
    if (close == std::string_view::npos) return fail(ig::diag("SYN-0022"), begin, text_.text.size());
    position_ = close + 1;
    if (close - begin > longest_text) return fail(ig::diag("SYN-0033"), begin, position_);
    return MacroValue::of_text(std::string(text_.text.substr(begin + 1, close - begin - 1)));
  }
  if (is_digit(c)) return hexadecimal();
  if (is_letter(c)) return named();
  return fail_here();
}

std::optional<MacroValue> MacroExpression::literal(bool is_negative) {
  const std::size_t begin = position_;
  const ig::Decimal d = ig::read_decimal(text_.text, position_);
  if (!d.ok) return fail_here();
  position_ = d.end;
  const double value = is_negative ? 0.0 - d.value : d.value;
  return d.has_point ? std::optional(MacroValue::real(value)) : whole_of(value, begin);
}

std::optional<MacroValue> MacroExpression::hexadecimal() {
  const std::size_t begin = position_;
  std::uint32_t bits = 0;
  const char* const first = text_.text.data() + position_ + 2;
  const auto [end, error] = std::from_chars(first, text_.text.data() + text_.text.size(), bits, 16);
  if (end == first) return fail(ig::diag("SYN-0021"), begin, text_.text.size());
  position_ = static_cast<std::size_t>(end - text_.text.data());
  if (error != std::errc{}) return fail(ig::diag("SYN-0033"), begin, position_);
  return MacroValue::whole(static_cast<double>(static_cast<std::int32_t>(bits)));
}

std::optional<MacroValue> MacroExpression::whole_of(double number, std::size_t begin) {
  if (!is_of_32_bits(number)) return fail(ig::diag("SYN-0033"), begin, position_);
  return MacroValue::whole(number + 0.0);
}

std::optional<MacroStore::Variable> MacroExpression::variable() {
  const std::size_t begin = position_;
  const char sign = here();
  if (sign != '#' && sign != '@') return fail_here();
  ++position_;
  double number = -1;
  if (here() == '[') {
    ++position_;
    const auto index = binary(0);
    if (!index) return std::nullopt;
    if (!accept(']')) return unclosed(begin);
    const auto value = operand(*index, begin);
    if (!value) return std::nullopt;
    number = *value;
  } else {
    const ig::Digits digits = ig::read_digits(text_.text, position_);
    if (digits.ok) number = static_cast<double>(digits.value);
    position_ = digits.end;
    if (is_letter(here()) && position_ == begin + 1)
      position_ = ig::cnc::skip_name_of(text_.text, position_, is_letter);
  }
  const auto out = sign == '#' ? hash_variable(number) : at_variable(number);
  if (out) return out;
  std::string name(piece(begin, position_));
  if (name.find('[') != std::string::npos) name += " (" + std::string(1, sign) + shown(MacroValue::real(number)) + ")";
  block_.report(ig::diag("SYN-0025"), text_.where(begin, position_), std::string_view(name));
  return std::nullopt;
}

std::optional<double> MacroExpression::operand(const MacroValue& value, std::size_t begin) {
  if (value.is_number()) return value.number;
  if (value.is_text()) return fail(ig::diag("SYN-0031"), begin, position_);
  block_.report(ig::diag("SYN-0032"), text_.where(begin, position_),
                value.text.empty() ? piece(begin, position_) : std::string_view(value.text));
  return 0.0;
}

std::optional<double> MacroExpression::whole_operand(const MacroValue& value, std::string_view what,
                                                     std::size_t begin) {
  if (value.is_whole()) return value.number;
  block_.report(ig::diag("SYN-0030"), text_.where(begin, position_), piece(begin, position_), what);
  return std::nullopt;
}

std::optional<MacroValue> MacroExpression::apply(Operator o, const MacroValue& a, const MacroValue& c,
                                                 std::size_t begin) {
  switch (o) {
    case Operator::unequal:
    case Operator::equal:
    case Operator::less:
    case Operator::greater:
    case Operator::less_or_equal:
    case Operator::greater_or_equal: return compare(o, a, c, begin);
    default: return calculate(o, a, c, begin);
  }
}

/// VACANT equals nothing but VACANT.
std::optional<MacroValue> MacroExpression::compare(Operator o, const MacroValue& a, const MacroValue& c,
                                                   std::size_t begin) {
  const bool is_equality = o == Operator::equal || o == Operator::unequal;
  if (is_equality && (a.is_vacant() || c.is_vacant()))
    return MacroValue::of_truth((a.is_vacant() && c.is_vacant()) == (o == Operator::equal));
  if (is_equality && (a.is_text() || c.is_text()))
    return MacroValue::of_truth((a.is_text() && c.is_text() && a.text == c.text) == (o == Operator::equal));
  const auto x = operand(a, begin), y = operand(c, begin);
  if (!x || !y) return std::nullopt;
  switch (o) {
    case Operator::unequal: return MacroValue::of_truth(*x != *y);
    case Operator::equal: return MacroValue::of_truth(*x == *y);
    case Operator::less: return MacroValue::of_truth(*x < *y);
    case Operator::greater: return MacroValue::of_truth(*x > *y);
    case Operator::less_or_equal: return MacroValue::of_truth(*x <= *y);
    default: return MacroValue::of_truth(*x >= *y);
  }
}

std::optional<MacroValue> MacroExpression::calculate(Operator o, const MacroValue& a, const MacroValue& c,
                                                     std::size_t begin) {
  if (o == Operator::modulo) {
    const auto x = whole_operand(a, "MOD", begin), y = whole_operand(c, "MOD", begin);
    if (!x || !y) return std::nullopt;
    if (*y == 0) return fail(ig::diag("SYN-0028"), begin, position_);
    return MacroValue::whole(std::fmod(*x, *y) + 0.0);
  }
  const auto x = operand(a, begin), y = operand(c, begin);
  if (!x || !y) return std::nullopt;
  const bool is_whole = a.kind != MacroValue::Kind::real && c.kind != MacroValue::Kind::real;
  if (o == Operator::and_ || o == Operator::or_ || o == Operator::xor_) {
    if (!is_whole) {
      const bool p = *x != 0, q = *y != 0;
      return MacroValue::of_truth(o == Operator::and_ ? p && q : o == Operator::or_ ? p || q : p != q);
    }
    const auto p = static_cast<std::int64_t>(*x), q = static_cast<std::int64_t>(*y);
    return MacroValue::whole(static_cast<double>(o == Operator::and_ ? p & q : o == Operator::or_ ? p | q : p ^ q));
  }
  double out = 0;
  switch (o) {
    case Operator::add: out = *x + *y; break;
    case Operator::subtract: out = *x - *y; break;
    case Operator::multiply: out = *x * *y; break;
    default:
      if (*y == 0) return fail(ig::diag("SYN-0028"), begin, position_);
      out = is_whole ? std::trunc(*x / *y) : *x / *y;
  }
  if (is_whole) return whole_of(out, begin);
  if (!std::isfinite(out)) return fail(ig::diag("SYN-0033"), begin, position_);
  return MacroValue::real(out + 0.0);
}

}  // namespace syntec
