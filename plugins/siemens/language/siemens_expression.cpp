// Priorities follow the manual "Job planning", arithmetic functions: NOT binds first, comparisons last.
#include "language/siemens_expression.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "language/expression_operators.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct Operator {
  std::string_view text;
  int priority;  // 1 binds first
};
// Longer operators come before those that they begin with.
constexpr Operator operators[] = {{"*", 1},     {"/", 1},    {"DIV", 1}, {"MOD", 1}, {"+", 2},  {"-", 2},  {"B_AND", 3},
                                  {"B_XOR", 4}, {"B_OR", 5}, {"AND", 6}, {"XOR", 7}, {"OR", 8}, {"<<", 9}, {"==", 10},
                                  {"<>", 10},   {">=", 10},  {"<=", 10}, {">", 10},  {"<", 10}};

}  // namespace

std::optional<Value> Expression::value() {
  auto v = level(loosest);
  return failed_ ? std::nullopt : v;
}

std::optional<double> Expression::number() {
  const std::size_t begin = at_;
  const auto v = value();
  if (!v) return std::nullopt;
  if (v->is_text()) return fail(ig::diag("SIE-0107"), begin, shown(begin));
  return v->number;
}

std::optional<bool> Expression::truth() {
  const auto n = number();
  return n ? std::optional(*n != 0) : std::nullopt;
}

/// Takes the operator of that priority at the present position; "" where there is none.
std::string_view Expression::take_operator(int priority) {
  skip_blanks();
  for (const Operator& o : operators) {
    const std::string_view here = text_.substr(at_, o.text.size());
    if (!equals_ignoring_case(here, o.text)) continue;
    if (is_name_start(o.text[0]) && is_name_part(ig::cnc::at(text_, at_ + o.text.size()))) continue;
    if (o.text == "<" && ig::cnc::at(text_, at_ + 1) == '<') continue;
    if (o.priority != priority) return {};
    at_ += o.text.size();
    return o.text;
  }
  return {};
}

std::optional<Value> Expression::level(int priority) {
  if (priority == 0) return unary();
  skip_blanks();
  const std::size_t begin = at_;
  auto left = level(priority - 1);
  for (int count = 0; left; ++count) {
    const std::string_view op = take_operator(priority);
    if (op.empty()) break;
    if (count == 1 && priority == loosest)
      environment_.report_once(b_, ig::diag("SIE-0108"), columns(begin, at_), begin, shown(begin));
    const auto right = level(priority - 1);
    if (!right) return std::nullopt;
    left = apply(op, *left, *right, begin);
  }
  return left;
}

/// Signs and NOT, any number of them.
std::optional<Value> Expression::unary() {
  std::string prefix;  // applied from its end
  skip_blanks();
  for (;; skip_blanks()) {
    const char c = peek();
    if (c == '-' || c == '+') {
      prefix += c;
      ++at_;
    } else if (const std::size_t end = skip_name(text_, at_);
               equals_ignoring_case(ig::cnc::piece(text_, at_, end), "NOT")) {
      prefix += '!';
      at_ = end;
    } else if (equals_ignoring_case(ig::cnc::piece(text_, at_, end), "B_NOT")) {
      prefix += '~';
      at_ = end;
    } else if (text_.substr(at_, 2) == "<<") {
      return as_text();
    } else {
      break;
    }
  }
  const std::size_t begin = at_;
  auto v = operand();
  if (!v) return std::nullopt;
  if (v->is_text() && !prefix.empty()) return fail(ig::diag("SIE-0107"), begin, shown(begin));
  for (std::size_t i = prefix.size(); i-- > 0;) {
    if (prefix[i] == '-') v->number = -v->number + 0.0;
    if (prefix[i] == '!') v = Value::truth(v->number == 0);
    if (prefix[i] == '~') {
      if (!is_bits(v->number)) return fail(ig::diag("SIE-0106"), begin, shown(begin));
      v = Value::integer(static_cast<double>(~static_cast<std::int32_t>(static_cast<std::int64_t>(v->number))));
    }
  }
  return v;
}

/// <<5 alone: the operand after it, as a text.
std::optional<Value> Expression::as_text() {
  at_ += 2;
  if (++depth_ > deepest) return fail(ig::diag("SIE-0103"), at_, static_cast<double>(deepest));
  const auto v = level(join_priority - 1);
  --depth_;
  return v ? std::optional(Value::string(text_of(*v))) : std::nullopt;
}

std::optional<Value> Expression::operand() {
  const std::size_t begin = at_;
  const char c = peek();
  if (c == '(') {
    if (++depth_ > deepest) return fail(ig::diag("SIE-0103"), begin, static_cast<double>(deepest));
    ++at_;
    auto v = level(loosest);
    --depth_;
    if (!v) return std::nullopt;
    skip_blanks();
    if (peek() != ')') return fail(ig::diag("SIE-0102"), begin);
    ++at_;
    return v;
  }
  if (is_digit(c) || c == '.' || c == '"' || c == '\'') return literal();
  if (is_name_start(c)) {
    const std::size_t end = skip_name(text_, at_);
    const std::string name = upper(ig::cnc::piece(text_, at_, end));
    if (name == "TRUE" || name == "FALSE") {
      at_ = end;
      return Value::truth(name == "TRUE");
    }
    if (name == "PI") {
      at_ = end;
      return Value::real(std::numbers::pi);
    }
    if (const std::string* const macro = environment_.macro(b_, name)) {
      at_ = end;
      return of_macro(begin, *macro);
    }
    if (const std::size_t open = ig::cnc::skip_blanks(text_, end); ig::cnc::at(text_, open) == '(') {
      at_ = open;
      return call(name, begin);
    }
  } else if (c != '$') {
    return fail(ig::diag("SIE-0101"), begin, next_text(begin));
  }
  const auto r = reference();
  return r ? read(*r) : std::nullopt;
}

/// The value of the DEFINE text of the name that was read.
std::optional<Value> Expression::of_macro(std::size_t begin, const std::string& macro) {
  if (depth_ > 0 && depth_ >= deepest) return fail(ig::diag("SIE-0103"), begin, static_cast<double>(deepest));
  const std::string padded = std::string(begin, ' ') + macro;
  Expression e(b_, environment_, padded, begin);
  e.depth_ = depth_ + 1;
  e.macro_name_begin_ = begin;
  e.macro_name_end_ = at_;
  const bool is_in_macro = macro_name_end_ != 0;
  auto v = is_in_macro ? std::nullopt : e.value();
  if (!is_in_macro && !v) {
    failed_ = true;
    return std::nullopt;
  }
  if (!v || ig::cnc::skip_blanks(padded, e.position()) < padded.size())
    return fail(ig::diag("SIE-0288"), begin, std::string_view(macro));
  return v;
}

std::optional<Value> Expression::literal() {
  const std::size_t begin = at_;
  if (peek() == '"') {
    const std::size_t close = text_.find('"', begin + 1);
    at_ = close == std::string_view::npos ? text_.size() : close + 1;
    if (close == std::string_view::npos) return fail(ig::diag("SIE-0102"), begin);
    return Value::string(std::string(ig::cnc::piece(text_, begin + 1, close)));
  }
  if (peek() == '\'') {  // 'HFF' and 'B101'
    const std::size_t close = std::min(text_.find('\'', begin + 1), text_.size());
    const std::string_view digits = ig::cnc::piece(text_, std::min(begin + 2, close), close);
    const char base = to_upper(ig::cnc::at(text_, begin + 1));
    std::uint32_t n = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n, base == 'H' ? 16 : 2);
    at_ = std::min(close + 1, text_.size());
    if ((base != 'H' && base != 'B') || error != std::errc{} || end != digits.data() + digits.size())
      return fail(ig::diag("SIE-0101"), begin, shown(begin));
    return Value::integer(n);
  }
  const ig::Decimal d = ig::read_decimal(text_, at_);
  at_ = std::max(d.end, begin + 1);
  if (!d.ok) return fail(ig::diag("SIE-0101"), begin, shown(begin));
  double value = d.value;
  bool is_whole = !d.has_point;
  if (equals_ignoring_case(text_.substr(at_, 2), "EX")) {
    const ig::Decimal power = ig::read_decimal(text_, at_ + 2);
    if (power.ok) {
      at_ = power.end;
      value *= std::pow(10, std::clamp(power.value, -400.0, 400.0));
      is_whole = false;
    }
  }
  if (!std::isfinite(value)) return fail(ig::diag("SIE-0105"), begin, shown(begin));
  return is_whole ? Value::integer(value) : Value::real(value);
}

}  // namespace siemens
