/// Diagnostics of the rotary axes: the part of the plugin's table that follows diagnostics.hpp.
#pragma once

#include "diagnostics.hpp"

namespace iso {

inline constexpr std::array rotary_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0401", "{0}: the machine has no such axis; the word moves nothing",
                   "The rows of MachineAxes (--machine FILE), or the parameters of the control, say which axes there "
                   "are. The word is not used; the other words of its block are.",
                   "G01 B30. F100"),
    ig::diagnostic(IG_NOTE, "ISO-0402", "no machine says which rotary axes there are: A, B and C turn without limits",
                   "They are taken as axes that turn on and on, by the shortest way to a position. Said once. Give "
                   "--machine FILE with a MachineAxes row for each axis.",
                   "G00 A90."),
    ig::diagnostic(IG_ERROR, "ISO-0403", "{0} would go to {1}: its travel ends at {2}",
                   "A control stops with an overtravel alarm. The move is shown as programmed. Said when an axis "
                   "leaves its travel, and again only after it was back inside. Limits are those of MachineAxes, or "
                   "parameters 1320 and 1321 of the control, in machine coordinates.",
                   "G53 Z10."),
    ig::diagnostic(IG_ERROR, "ISO-0404", "{0} {1}: no rotary axis has such a position; the axis stays where it is",
                   "Angles are counted up to a thousand million degrees.", "G00 A1e10"),
};

consteval std::uint32_t rotary_diag(std::string_view code) {
  return index_of(rotary_diagnostics, code, diagnostics.size());
}

}  // namespace iso
