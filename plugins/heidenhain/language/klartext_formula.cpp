// The formulas of Q parameters, computed while they are read: sums of products of powers of values, brackets and
// functions. The signs before a value bind closer than a power.
#include <cmath>
#include <limits>
#include <numbers>

#include <isogloss/cnc/degrees.hpp>
#include <isogloss/cnc/units.hpp>

#include "language/klartext_values.hpp"
#include "language/string_formula.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

constexpr int deepest_formula = 100;

struct FormulaParser {
  const Values& values;
  ig::Block& b;
  std::string_view text;
  std::size_t position;
  int depth;
  bool failed;

  double sum() {
    double left = product();
    while (!failed) {
      position = skip(text, position);
      const char c = at(text, position);
      if (c != '+' && c != '-') break;
      ++position;
      const double right = product();
      left = c == '+' ? left + right : left - right;
    }
    return left;
  }
  double product() {
    double left = power();
    while (!failed) {
      position = skip(text, position);
      const char c = at(text, position);
      const std::size_t div = keyword(text, position, "DIV");
      if (c == '*' || c == '/' || c == '%')
        ++position;
      else if (div != position)
        position = div;
      else
        break;
      const double right = power();
      if (c == '*')
        left *= right;
      else if (c == '%')
        left = std::fmod(left, right);
      else
        left /= right;
    }
    return left;
  }
  double power() {
    double left = value();
    while (!failed) {
      position = skip(text, position);
      if (at(text, position) != '^') break;
      ++position;
      const double right = value();
      left = std::pow(left, right);
    }
    return left;
  }
  double value() {
    position = skip(text, position);
    if (++depth > deepest_formula) {
      if (!failed) b.report(ig::diag("HEI-0112"), ig::Where::columns(position, position + 1), double{deepest_formula});
      failed = true;
    }
    if (failed) return 0;
    const double result = value_inside();
    --depth;
    return result;
  }
  double value_inside() {
    const char c = at(text, position);
    if (c == '+' || c == '-') {
      ++position;
      const double inner = value();
      return c == '-' ? -inner : inner;
    }
    if (c == '(') {
      const std::size_t open = position++;
      const double inner = sum();
      position = skip(text, position);
      if (failed) return 0;
      if (at(text, position) != ')') {
        b.report(ig::diag("HEI-0111"), ig::Where::columns(open, open + 1));
        failed = true;
        return 0;
      }
      ++position;
      return inner;
    }
    const Value v = values.read(b, text, position);
    if (v.ok) {
      position = v.end;
      return v.number;
    }
    return function();
  }
  double function() {
    static constexpr std::array<std::string_view, 18> names{"SQRT", "SQ",   "SIN", "COS", "TAN",  "ASIN",
                                                            "ACOS", "ATAN", "ABS", "INT", "FRAC", "NEG",
                                                            "SGN",  "LN",   "LOG", "EXP", "PI",   "MOD"};
    if (StringFormula::is_number_function(text, position)) return of_text();
    const std::size_t end = letters_end(text, position);
    for (std::size_t i = 0; i < names.size() && end > position; ++i) {
      if (!equals_ignoring_case(piece(text, position, end), names[i])) continue;
      position = end;
      if (i == 16) return std::numbers::pi;
      return result_of(i, value());
    }
    no_value();
    return 0;
  }
  double of_text() {
    StringFormula formula(b, values, text, position);
    const auto result = formula.number();
    failed = failed || !result;
    position = formula.position();
    return result.value_or(0);
  }
  static double result_of(std::size_t function, double x) {
    switch (function) {
      case 0: return std::sqrt(x);
      case 1: return x * x;
      case 2: return sine(x);
      case 3: return cosine(x);
      case 4: return tangent(x);
      case 5: return arc_sine(x);
      case 6: return arc_cosine(x);
      case 7: return std::atan(x) / radians_per_degree;
      case 8: return std::fabs(x);
      case 9: return std::trunc(x);
      case 10: return x - std::trunc(x);
      case 11: return -x;
      case 12: return x > 0 ? 1 : x < 0 ? -1 : 0;
      case 13: return std::log(x);
      case 14: return std::log10(x);
      case 15: return std::exp(x);
      default: return std::numeric_limits<double>::quiet_NaN();
    }
  }
  void no_value() {
    if (failed) return;
    failed = true;
    const std::size_t end = std::max(position + 1, skip_while(text, position, [](char c) { return !is_space(c); }));
    b.report(ig::diag("HEI-0110"), ig::Where::columns(position, end),
             text.substr(std::min(position, text.size()), end - position));
  }
};

}  // namespace

std::optional<double> Values::formula(ig::Block& b, std::string_view text, std::size_t position,
                                      std::size_t end) const {
  FormulaParser parser{*this, b, text.substr(0, end), position, 0, false};
  const double result = parser.sum();
  if (parser.failed) return std::nullopt;
  parser.position = skip(parser.text, parser.position);
  if (parser.position < end) {
    if (parser.text[parser.position] == ')')
      b.report(ig::diag("HEI-0110"), ig::Where::columns(parser.position, parser.position + 1), std::string_view(")"));
    else
      parser.no_value();
    return std::nullopt;
  }
  if (std::isfinite(result)) return result + 0.0;
  b.report(ig::diag("HEI-0113"), ig::Where::columns(position, end), trim(piece(text, position, end)));
  b.alarm();
  return std::nullopt;
}

}  // namespace heidenhain
