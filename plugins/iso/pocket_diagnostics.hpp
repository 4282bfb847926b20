/// Diagnostics of pockets: the part of the plugin's table that follows rotary_offset_diagnostics.hpp.
#pragma once

#include "rotary_offset_diagnostics.hpp"

namespace iso {

inline constexpr std::array pocket_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0501", "{0} without {1}: nothing is milled",
                   "A circular pocket needs I, the radius of its first circle; K, the radius of the last one, needs Q, "
                   "the step from circle to circle.",
                   "G13 K20. D1 F200"),
    ig::diagnostic(IG_ERROR, "ISO-0502", "{0}: {1}{2} is no such length: nothing is milled",
                   "I and Q are greater than 0, K is not less than I.", "G13 I10. K5. Q2. D1 F200"),
    ig::diagnostic(IG_ERROR, "ISO-0503",
                   "{0}: the tool (radius {1}) does not fit into the circle I{2}: nothing is milled",
                   "The radius of the first circle is greater than the tool's. D0 takes I as the way of the tool's "
                   "centre.",
                   "G13 I5. D1 F200 (with a radius of 6 mm in D1)"),
    ig::diagnostic(IG_ERROR, "ISO-0504", "{0} L{1}: a pocket is milled in 1 to 1000 passes; nothing is milled",
                   "L says how often the circles are milled; under G91 each pass goes deeper by Z.",
                   "G13 G91 Z-1. I10. L2.5 D1 F200"),
    ig::diagnostic(IG_ERROR, "ISO-0505", "{0}: {1} circles are too many for one block; nothing is milled",
                   "A block makes at most 10000 circles, over all its passes.", "G13 I1. K500. Q0.001 D0 F200"),
    ig::diagnostic(IG_ERROR, "ISO-0506", "{0} outside the XY plane: nothing is milled",
                   "The control mills circular pockets in XY alone. Program G17.", "G18 (then) G13 I10. D1 F200"),
};

inline constexpr std::size_t pocket_begin = pattern_end + rotary_offset_diagnostics.size();
inline constexpr std::size_t pocket_end = pocket_begin + pocket_diagnostics.size();

consteval std::uint32_t pocket_diag(std::string_view code) { return index_of(pocket_diagnostics, code, pocket_begin); }

}  // namespace iso
