/// Diagnostics of the rotary axes: the part of the plugin's table that follows diagnostics.hpp.
#pragma once

#include "diagnostics.hpp"

namespace iso {

inline constexpr std::array rotary_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0401", "{0}: the machine has no such axis; the word moves nothing",
                   "The rows of MachineAxes say which axes there are (--machine FILE).", "G01 B30. F100"),
};

consteval std::uint32_t rotary_diag(std::string_view code) {
  return index_of(rotary_diagnostics, code, diagnostics.size());
}

}  // namespace iso
