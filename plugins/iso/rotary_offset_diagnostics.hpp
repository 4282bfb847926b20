/// Diagnostics of the offsets of rotary axes: the part of the plugin's table that follows
/// radius_compensation_diagnostics.hpp.
#pragma once

#include "pattern_diagnostics.hpp"

namespace iso {

inline constexpr std::array rotary_offset_diagnostics{
    ig::diagnostic(IG_WARNING, "ISO-0405",
                   "the offset of a rotary axis changes here: A B C of this block count from "
                   "the offset of before",
                   "While the tool is led or stands upright on a plane (G43.4, G43.5, G53.1, G53.6) the axes turn "
                   "before the block's work offsets count. Select the work offset in a block of its own.",
                   "G43.4 H1 (then) G52 A30. (with axis A and its kinematics)"),
};

consteval std::uint32_t rotary_offset_diag(std::string_view code) {
  return index_of(rotary_offset_diagnostics, code, pattern_end);
}

}  // namespace iso
