/// What differs between controls in custom macro B, as the options of MacroVariables and of the syntaxes set it.
#pragma once

#include <cstdint>

#include "macro/expression.hpp"

namespace fanuc {

/// The meaning of #2001 and #10001 and above: wear of lengths, then their geometry; the other way round (Series 15); or
/// the geometry first, while #10001 and above are not tools (Haas).
enum class ToolVariables { wear_first, series_15, geometry_first };

struct MacroSettings {
  ExpressionRules rules;
  std::uint32_t nesting = 5;       ///< levels of brackets that the control permits
  std::uint32_t call_nesting = 5;  ///< levels of macro calls that the control permits
  ToolVariables tools = ToolVariables::wear_first;
  bool radii_from_2401 = false;  ///< #2401 to #2800 are tool radii; else #2500 and above are work offsets
  bool local_in_5201 = false;    ///< #5201 and above are the shift of G52; else the external offset
  std::uint32_t tool_variable = 0, speed_variable = 0;  ///< the tool in the spindle, and its speed; 0: no variable
  bool offset_in_12 = false;                            ///< #4012 is the work offset; else the modal macro call
  bool repeats_keep_locals = false;                     ///< G65 L: only the first pass begins with the arguments
  double clock_step_ms = 100;                           ///< by how much the clocks advance each time they are read
};

}  // namespace fanuc
