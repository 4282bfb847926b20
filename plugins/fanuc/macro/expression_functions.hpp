/// The functions of custom macro B, from SIN[] to POW[,]: their names and their values. Angles are in degrees.
#pragma once

#include <string_view>

#include "macro/expression.hpp"

namespace fanuc {

using namespace ig::cnc;

enum class MacroFunction : std::uint8_t {
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sqrt,
  abs,
  bin,
  bcd,
  round,
  fix,
  fup,
  ln,
  exp,
  pow,
  adp,
  prm,
  none
};

/// By its name, or by its first two letters; in capitals or small letters.
MacroFunction macro_function(std::string_view name);

/// `y` is the second argument, which only POW reads. The value may be infinite.
Fault function_value(MacroFunction which, double x, double y, const ExpressionRules& rules, double& out);

/// ATAN[y]/[x], ATAN[y,x].
Fault arc_tangent(double y, double x, const ExpressionRules& rules, double& out);

}  // namespace fanuc
