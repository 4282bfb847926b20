/// Diagnostics of the tool's direction: G53.1, G53.6 and tool centre point control. The part of the plugin's table that
/// follows tilt_diagnostics.hpp.
#pragma once

#include "tilt_diagnostics.hpp"

namespace iso {

inline constexpr std::array tool_center_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0441", "{0} without a tilted plane: the rotary axes stay where they are",
                   "It turns the tool upright on the plane that G68.2 has defined.", "G53.1"),
};

consteval std::uint32_t tool_center_diag(std::string_view code) {
  return index_of(tool_center_diagnostics, code,
                  diagnostics.size() + rotary_diagnostics.size() + tilt_diagnostics.size());
}

}  // namespace iso
