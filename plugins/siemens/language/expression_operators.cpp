/// The operators of an expression: arithmetic, comparisons, logic, bits, and << for texts.
#include "language/expression_operators.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "language/siemens_expression.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

constexpr double relative_equality = 1e-12;

}  // namespace

std::string text_of(const Value& v) {
  if (v.is_text()) return v.text;
  if (v.type == Type::boolean) return v.number != 0 ? "1" : "0";
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), v.number).ptr;
  return {digits.data(), end};
}

std::optional<Value> Expression::apply(std::string_view op, const Value& l, const Value& r, std::size_t begin) {
  if (op == "<<") {
    std::string joined = text_of(l) + text_of(r);
    if (joined.size() > 4096) return fail(ig::diag("SIE-0105"), begin, std::string_view("<<"));
    return Value::string(std::move(joined));
  }
  if (l.is_text() && r.is_text()) {
    if (op == "==") return Value::truth(l.text == r.text);
    if (op == "<>") return Value::truth(l.text != r.text);
  }
  if (l.is_text() || r.is_text()) return fail(ig::diag("SIE-0107"), begin, shown(begin));
  const double a = l.number, c = r.number;
  // The control compares with a relative equality (Job planning, "Precision correction on comparison errors").
  const bool is_same = a == c || std::fabs(a - c) <= relative_equality * std::fmax(std::fabs(a), std::fabs(c));
  if (op == "==") return Value::truth(is_same);
  if (op == "<>") return Value::truth(!is_same);
  if (op == "<") return Value::truth(a < c && !is_same);
  if (op == ">") return Value::truth(a > c && !is_same);
  if (op == "<=") return Value::truth(a < c || is_same);
  if (op == ">=") return Value::truth(a > c || is_same);
  if (op == "AND") return Value::truth(a != 0 && c != 0);
  if (op == "OR") return Value::truth(a != 0 || c != 0);
  if (op == "XOR") return Value::truth((a != 0) != (c != 0));
  if (op.starts_with("B_")) {
    if (!is_bits(a) || !is_bits(c)) return fail(ig::diag("SIE-0106"), begin, shown(begin));
    const auto x = static_cast<std::int64_t>(a), y = static_cast<std::int64_t>(c);
    return Value::integer(static_cast<double>(op == "B_AND" ? x & y : op == "B_OR" ? x | y : x ^ y));
  }
  if ((op == "/" || op == "DIV" || op == "MOD") && c == 0) return fail(ig::diag("SIE-0307"), begin, shown(begin));
  const bool whole = l.type != Type::real && r.type != Type::real;
  double out = 0;
  if (op == "+") out = a + c;
  if (op == "-") out = a - c;
  if (op == "*") out = a * c;
  if (op == "/") out = a / c;
  if (op == "DIV") out = std::trunc(a / c);
  if (op == "MOD") out = std::fmod(a, c);
  if (!std::isfinite(out)) return fail(ig::diag("SIE-0105"), begin, shown(begin));
  const bool is_whole = op == "DIV" || op == "MOD" || (whole && op != "/");
  return is_whole ? Value::integer(out) : Value::real(out);
}

}  // namespace siemens
