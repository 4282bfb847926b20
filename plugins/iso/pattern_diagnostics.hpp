/// Diagnostics of hole patterns and of what some controls have more of: pecks that grow smaller, further work
/// coordinate systems, taps that leave faster. The part of the plugin's table that follows
/// radius_compensation_diagnostics.hpp.
#pragma once

#include "radius_compensation_diagnostics.hpp"

namespace iso {

inline constexpr std::array pattern_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0355", "{0} without a canned cycle: nothing is drilled",
                   "A pattern drills its holes with the cycle in force, or with that of its own block (G81 to G89 and "
                   "the like). Neither is there.",
                   "G80 (then) G70 I20. J0 L6"),
    ig::diagnostic(IG_NOTE, "ISO-0356", "{0} without P: P1 counts",
                   "The code names a work coordinate system by P. Write P1 where the first one is meant.", "G154"),
    ig::diagnostic(IG_ERROR, "ISO-0357", "{0}: {1}{2} is no number of holes: nothing is drilled",
                   "L is a whole number from 1 to 10000.", "G70 I20. J0 L2.5"),
    ig::diagnostic(
        IG_ERROR, "ISO-0358", "{0} without {1}: nothing is drilled",
        "A circle and an arc of holes need I (radius) and L (number), the arc K (angle between holes) too; a "
        "line needs I (distance) and L. J, the angle, is 0 where it is left out.",
        "G70 J0 L6"),
    ig::diagnostic(IG_WARNING, "ISO-0359", "{0}: {1}{2} is negative: a peck has no sign, the sign is ignored",
                   "I, J and K of a peck cycle are depths of cut and always positive.",
                   "G83 Z-20. R2. I-8. J1. K2. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0372", "{0}: I without K: pecks do not grow smaller than {1} mm",
                   "Each peck is J less than the one before, down to K. Without K they would come to nothing; the last "
                   "size above 0 is kept.",
                   "G83 Z-20. R2. I8. J1. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0373", "{0} before any G20 or G21: lengths count as {1}",
                   "The program has not said its unit, so a setting of the machine decides. Write G20 or G21 first, or "
                   "say how the machine is set. Said once in a run.",
                   "X1. (in a program without G20 and G21)"),
    ig::diagnostic(IG_WARNING, "ISO-0374", "{0}: the tap cannot leave {1} times as fast; J is left out",
                   "J of a tapping cycle says how many times as fast the tap leaves the hole, from above 0 to 20.",
                   "G84 Z-15. R5. F750. J-2."),
    ig::diagnostic(
        IG_ERROR, "ISO-0560", "{0}: the lengths before it are {1}, and this control cannot change its unit: it stops",
        "On this control a parameter of the machine is the unit, and G20 and G21 only check it. The first of "
        "them, or the first length, tells how the machine is set; a later code that says otherwise is an "
        "alarm.",
        "G21 / X1 / G20"),
};

inline constexpr std::size_t pattern_end = radius_end + pattern_diagnostics.size();

consteval std::uint32_t pattern_diag(std::string_view code) { return index_of(pattern_diagnostics, code, radius_end); }

}  // namespace iso
