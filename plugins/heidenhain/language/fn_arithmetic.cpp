#include "language/fn_arithmetic.hpp"

#include <isogloss/cnc/degrees.hpp>
#include <isogloss/cnc/units.hpp>

namespace heidenhain {

using namespace ig::cnc;

namespace {

constexpr bool has_one_operand(unsigned fn) { return fn == 0 || (fn >= 5 && fn <= 7); }

double of_one_operand(unsigned fn, double x) {
  switch (fn) {
    case 5: return std::sqrt(x);
    case 6: return sine(x);
    case 7: return cosine(x);
    default: return x;
  }
}

double of_two_operands(unsigned fn, double left, double right) {
  switch (fn) {
    case 1: return left + right;
    case 2: return left - right;
    case 3: return left * right;
    case 4: return left / right;
    case 8: return std::hypot(left, right);
    default: {
      const double angle = std::atan2(left, right) / radians_per_degree;
      return angle < 0 ? angle + 360 : angle;
    }
  }
}

/// The position after the operator between the two operands; a sign of the second one may follow.
std::size_t behind_operator(std::string_view text, std::size_t position, unsigned fn) {
  const std::size_t i = skip(text, position);
  if (fn == 1) return at(text, i) == '+' ? i + 1 : i;
  if (fn == 2) return at(text, i) == '-' ? i + 1 : i;
  if (fn == 3) return at(text, i) == '*' ? i + 1 : i;
  if (fn == 4 && at(text, i) == '/') return i + 1;
  return glued(text, i, fn == 4 ? "DIV" : fn == 8 ? "LEN" : "ANG");
}

}  // namespace

std::optional<FnResult> compute_fn(const ParameterReader& reader, std::size_t position, unsigned number) {
  const std::string_view text = reader.text;
  const auto target = reader.target(position);
  if (!target) return std::nullopt;
  std::size_t i = skip(text, target->after);
  if (number >= 5 && number <= 7) {
    const std::string_view word = number == 5 ? "SQRT" : number == 6 ? "SIN" : "COS";
    for (const char c : word) i += to_upper(at(text, i)) == c ? 1 : 0;
  }
  const auto left = reader.value(i);
  if (!left) return std::nullopt;
  double result = 0;
  if (has_one_operand(number)) {
    result = of_one_operand(number, *left);
  } else {
    const std::size_t behind = behind_operator(text, i, number);
    if (behind == i || skip(text, i) == behind) {
      reader.missing("the operator");
      return std::nullopt;
    }
    i = behind;
    const auto right = reader.value(i);
    if (!right) return std::nullopt;
    result = of_two_operands(number, *left, *right);
  }
  if (!reader.ends(i)) return std::nullopt;
  return FnResult{*target, result};
}

}  // namespace heidenhain
