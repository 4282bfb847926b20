/// The functions of custom macro B. Exact where the answer is; what no number answers is a fault.
#include "macro/expression_functions.hpp"

#include <array>
#include <cmath>
#include <cstdint>

#include <isogloss/cnc/degrees.hpp>
#include <isogloss/cnc/units.hpp>

#include "macro/expression_letters.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

struct FunctionName {
  std::string_view name;
  MacroFunction function;
};
constexpr std::array functions{FunctionName{"SIN", MacroFunction::sin},   FunctionName{"COS", MacroFunction::cos},
                               FunctionName{"TAN", MacroFunction::tan},   FunctionName{"ASIN", MacroFunction::asin},
                               FunctionName{"ACOS", MacroFunction::acos}, FunctionName{"ATAN", MacroFunction::atan},
                               FunctionName{"ATN", MacroFunction::atan},  FunctionName{"SQRT", MacroFunction::sqrt},
                               FunctionName{"SQR", MacroFunction::sqrt},  FunctionName{"ABS", MacroFunction::abs},
                               FunctionName{"BIN", MacroFunction::bin},   FunctionName{"BCD", MacroFunction::bcd},
                               FunctionName{"RND", MacroFunction::round}, FunctionName{"ROUND", MacroFunction::round},
                               FunctionName{"FIX", MacroFunction::fix},   FunctionName{"FUP", MacroFunction::fup},
                               FunctionName{"LN", MacroFunction::ln},     FunctionName{"EXP", MacroFunction::exp},
                               FunctionName{"POW", MacroFunction::pow},   FunctionName{"ADP", MacroFunction::adp},
                               FunctionName{"PRM", MacroFunction::prm}};

double in_degrees(double radians) { return radians * degrees_per_radian; }

/// Half away from zero.
double round_to(double value, double increment) {
  if (increment == 0) return std::round(value);
  const double per_unit = std::round(1 / increment);
  return std::round(value * per_unit) / per_unit;
}

/// From -180 to 180, or from 0 to 360 as the rules say.
double arc(double degrees, const ExpressionRules& rules) {
  return degrees < 0 && !rules.arcs_are_signed ? degrees + 360 : degrees;
}

/// BIN: four bits are one decimal digit.
Fault binary_from_decades(double x, double& out) {
  const double whole = std::round(x);
  if (!(whole >= 0 && whole <= 4294967295.0)) return Fault::no_bits;
  double value = 0, place = 1;
  for (auto rest = static_cast<std::uint32_t>(whole); rest != 0; rest >>= 4, place *= 10) {
    if ((rest & 15u) > 9) return Fault::no_bits;
    value += place * (rest & 15u);
  }
  out = value;
  return Fault::none;
}
/// BCD: each decimal digit becomes four bits.
Fault decades_from_binary(double x, double& out) {
  const double whole = std::round(x);
  if (!(whole >= 0 && whole <= 99'999'999)) return Fault::no_bits;
  std::uint32_t value = 0, shift = 0;
  for (auto rest = static_cast<std::uint32_t>(whole); rest != 0; rest /= 10, shift += 4) value |= rest % 10 << shift;
  out = value;
  return Fault::none;
}

}  // namespace

MacroFunction macro_function(std::string_view name) {
  for (const FunctionName& f : functions)
    if (detail::equals(name, f.name) || (name.size() == 2 && detail::equals(name, f.name.substr(0, 2))))
      return f.function;
  return MacroFunction::none;
}

Fault function_value(MacroFunction which, double x, double y, const ExpressionRules& rules, double& out) {
  const auto no_value = Fault::out_of_domain;
  const auto of = [&](double value) {
    out = value;
    return Fault::none;
  };
  switch (which) {
    case MacroFunction::sin: return of(sine(x));
    case MacroFunction::cos: return of(cosine(x));
    case MacroFunction::tan:
      if (std::abs(std::remainder(x, 180.0)) == 90) return no_value;
      return of(tangent(x));
    case MacroFunction::asin: {
      if (!(std::abs(x) <= 1)) return no_value;
      return of(arc(arc_sine(x), rules));
    }
    case MacroFunction::acos: return std::abs(x) <= 1 ? of(arc_cosine(x)) : no_value;
    case MacroFunction::atan: return of(in_degrees(std::atan(x)));
    case MacroFunction::sqrt: return x >= 0 ? of(std::sqrt(x)) : no_value;
    case MacroFunction::abs: return of(std::abs(x));
    case MacroFunction::bin: return binary_from_decades(x, out);
    case MacroFunction::bcd: return decades_from_binary(x, out);
    case MacroFunction::round: return of(round_to(x, rules.increment));
    case MacroFunction::fix: return of(std::trunc(x));
    case MacroFunction::fup: return of(x < 0 ? std::floor(x) : std::ceil(x));
    case MacroFunction::ln: return x > 0 ? of(std::log(x)) : no_value;
    case MacroFunction::exp: return of(std::exp(x));
    case MacroFunction::pow: {
      const double power = std::pow(x, y);
      return std::isnan(power) || (x == 0 && y < 0) ? no_value : of(power);
    }
    case MacroFunction::adp: return of(x);
    default: return no_value;
  }
}

Fault arc_tangent(double y, double x, const ExpressionRules& rules, double& out) {
  if (x == 0 && y == 0) return Fault::out_of_domain;
  out = arc(in_degrees(std::atan2(y, x)), rules);
  return Fault::none;
}

}  // namespace fanuc
