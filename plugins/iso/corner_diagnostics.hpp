/// Diagnostics of corners that a program rounds: the part of the plugin's table that follows pocket_diagnostics.hpp.
#pragma once

#include "pocket_diagnostics.hpp"

namespace iso {

inline constexpr std::array corner_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0478", "G39 is not executed: {0}",
                   "G39 stands alone in its block, under G41 or G42, between two moves in the plane; without I J K the "
                   "move behind it says where the arc ends.",
                   "G41 ... (then) G39 X10."),
    ig::diagnostic(IG_ERROR, "ISO-0479", "G39 at an inner corner: the tool goes straight, without an arc",
                   "The arc leads round an outer corner. At an inner one it would lie in the part.",
                   "G41 D1 (radius 5) (then) X10. (then) G39 (then) Y10."),
    ig::diagnostic(
        IG_ERROR, "ISO-0480", "{0} is not executed, the corner stays sharp: {1}",
        "A chamfer (,C) or a rounding (,R) stands between two feed moves in the plane, which are both long "
        "enough for it; one block without a move may stand between them. The tool goes to the corner itself.",
        "G01 X10. ,C11. F100 (then) Y10."),
};

inline constexpr std::size_t corner_end = pocket_end + corner_diagnostics.size();

consteval std::uint32_t corner_diag(std::string_view code) { return index_of(corner_diagnostics, code, pocket_end); }

}  // namespace iso
