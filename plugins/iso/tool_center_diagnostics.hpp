/// Diagnostics of the tool's direction: G53.1, G53.6 and tool centre point control. The part of the plugin's table that
/// follows tilt_diagnostics.hpp.
#pragma once

#include "tilt_diagnostics.hpp"

namespace iso {

inline constexpr std::array tool_center_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0441", "{0} without a tilted plane: the rotary axes stay where they are",
                   "It turns the tool upright on the plane that G68.2 has defined.", "G53.1"),
    ig::diagnostic(IG_ERROR, "ISO-0442", "{0}: where the rotary axes of the machine sit is not known: nothing turns",
                   "Angles follow from the directions of the axes: a dependency MachineKinematics, mostly from "
                   "--machine FILE. Positions in the plane hold for a machine that has turned. Said once a run.",
                   "G68.2 X0 Y0 Z0 I0 J30. K0 (then) G53.1"),
    ig::diagnostic(IG_ERROR, "ISO-0443",
                   "{0}: the rotary axes cannot turn the tool to {1}, {2}, {3}: they stay where they are",
                   "No pair of angles, whatever the limits of the axes are, gives the tool this direction.",
                   "G68.2 X0 Y0 Z0 I0 J90. K0 (then) G53.1"),
    ig::diagnostic(IG_ERROR, "ISO-0444", "{0}: outside the travel of the rotary axes, so they stay where they are",
                   "Of the pairs of angles that give the tool its direction, none that the block allows lies inside "
                   "the limits (MachineAxes). Limits are inclusive. The control stops with an alarm.",
                   "G68.2 X0 Y0 Z0 I0 J90. K0 (then) G53.1"),
    ig::diagnostic(IG_WARNING, "ISO-0445", "{0} under {1}: the control may refuse it; it is executed",
                   "Fanuc stops with an alarm for functions that tool centre point control excludes. End it with G49 "
                   "first.",
                   "G43.4 H1 (then) G28 Z0"),
    ig::diagnostic(IG_ERROR, "ISO-0446", "an arc while the rotary axes turn: a straight line is made",
                   "Under tool centre point control only straight moves are computed together with rotary axes. Arcs "
                   "with resting rotary axes are.",
                   "G43.4 H1 (then) G02 X10. I5. A10. F100"),
    ig::diagnostic(IG_ERROR, "ISO-0447",
                   "{0}: where the rotary axes of the machine sit is not known: the tip does not follow them",
                   "The tip can be kept on its path only where the axes are known: a dependency MachineKinematics, "
                   "mostly from --machine FILE. The length of the tool lies along Z, as under G43. Positions are "
                   "unreliable wherever a rotary axis is not at zero. Said "
                   "once a run.",
                   "G43.4 H1"),
    ig::diagnostic(IG_ERROR, "ISO-0448", "{0} stands alone in its block: X Y Z beside it move nothing",
                   "The control wants a block of its own for it. Write the move in the next one.",
                   "G68.2 X0 Y0 Z0 I0 J30. K0 (then) G53.1 X10."),
    ig::diagnostic(IG_WARNING, "ISO-0449", "the tool does not stand upright on the plane: it leans by {0} degrees",
                   "A rotary word after G53.1, or beside it, has turned an axis to where the tool is no normal of the "
                   "tilted plane. X Y Z of the machine stay; the plane turns with the workpiece.",
                   "G68.2 X0 Y0 Z0 I0 J30. K0 (then) G53.1 (then) G00 A0"),
    ig::diagnostic(IG_ERROR, "ISO-0450", "I0 J0 K0 is no direction: the tool stays as it is",
                   "Under G43.5 I J K is the way from the tip of the tool to its holder, of any length but none.",
                   "G43.5 H1 (then) G01 X1. I0 J0 K0 F100"),
    ig::diagnostic(IG_ERROR, "ISO-0451", "rotary words under G43.5: they move nothing",
                   "Under G43.5 the angles follow from I J K; the control refuses A B C. G43.4 takes them.",
                   "G43.5 H1 (then) G01 X1. A10. F100"),
    ig::diagnostic(IG_ERROR, "ISO-0452", "{0} under {1}: nothing turns",
                   "The order is G68.2, then G53.1, then G43.4; G49 before the next plane.",
                   "G43.4 H1 (then) G68.2 X0 Y0 Z0 I0 J30. K0 (then) G53.1"),
    ig::diagnostic(IG_ERROR, "ISO-0453", "{0} P{1}: P is 0, 1 or 2; nothing turns",
                   "0: the solution that the order of the control gives, 1: the one with the first rotary axis at a "
                   "positive angle, 2: at a negative one.",
                   "G68.2 X0 Y0 Z0 I0 J30. K0 (then) G53.1 P3"),
    ig::diagnostic(IG_ERROR, "ISO-0454", "an arc under G43.5: I J K is the direction of the tool, and it is not used",
                   "Write the arc with R, or with G43.4. I J K of this block are left to the arc.",
                   "G43.5 H1 (then) G02 X10. I5. J0 F100"),
};

consteval std::uint32_t tool_center_diag(std::string_view code) {
  return index_of(tool_center_diagnostics, code,
                  diagnostics.size() + rotary_diagnostics.size() + tilt_diagnostics.size());
}

/// Where the next part of the plugin\'s table begins.
inline constexpr std::size_t tool_center_end =
    diagnostics.size() + rotary_diagnostics.size() + tilt_diagnostics.size() + tool_center_diagnostics.size();

}  // namespace iso
