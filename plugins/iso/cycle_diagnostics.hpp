/// Diagnostics of canned cycles that came later: the part of the plugin's table that follows
/// tool_center_diagnostics.hpp.
#pragma once

#include "tool_center_diagnostics.hpp"

namespace iso {

inline constexpr std::array cycle_diagnostics{
    ig::diagnostic(
        IG_WARNING, "ISO-0354", "{0}: {1}{2} has no effect in this cycle",
        "The control takes the word without an alarm and keeps it for a later cycle of the same run of holes. "
        "Here nothing comes of it: a Fanuc does not dwell in G73, G81, G83, G85 and G86, whatever P says. G82 "
        "and G89 do.",
        "G83 X10. Y10. Z-20. R2. Q5. P500 F100"),
};

inline constexpr std::size_t cycle_end = tool_center_end + cycle_diagnostics.size();

consteval std::uint32_t cycle_diag(std::string_view code) { return index_of(cycle_diagnostics, code, tool_center_end); }

}  // namespace iso
