/// Diagnostics of tilted planes: the part of the plugin's table that follows rotary_diagnostics.hpp.
#pragma once

#include "rotary_diagnostics.hpp"

namespace iso {

inline constexpr std::array tilt_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0421", "{0} P{1}: P is a whole number from 0 to 4; the plane stays as it was",
                   "P says how the words define the plane: Euler angles, roll pitch yaw, three points, two vectors, "
                   "projection angles. Positions from here on are unreliable.",
                   "G68.2 P7 X0 Y0 Z0 I0 J30. K0"),
    ig::diagnostic(
        IG_WARNING, "ISO-0422", "{0} while {1} is in force: the new plane replaces the old one",
        "Controls want the plane that is in force ended by G69 first; some stop with an alarm. The new plane "
        "counts from the workpiece coordinates, as if G69 had been programmed. G68.4 counts from the plane "
        "in force.",
        "G68.2 X0 Y0 Z0 J30. (then) G68.2 X50. Y0 Z0 J30."),
    ig::diagnostic(IG_ERROR, "ISO-0423", "{0}: the plane cannot be computed; the plane stays as it was",
                   "Its words are too large. Look for a typing error. Positions from here on are unreliable.",
                   "G68.2 X1 Y1 I45. J45. (then) G68.4 X1 Y1 Z1, each X Y Z with 308 zeros after it"),
    ig::diagnostic(
        IG_WARNING, "ISO-0424", "{0} while a plane is tilted: end it by G69 first",
        "Controls forbid reference returns and other coordinate systems inside a tilted plane, and differ about "
        "machine coordinates: an alarm, or positions that nobody wants. Here the plane stays, with its origin in "
        "workpiece coordinates, and the code does what it does without a plane.",
        "G55 (while G68.2 is in force)"),
    ig::diagnostic(
        IG_ERROR, "ISO-0425", "{0} P{1} was not finished: {2} is missing; the plane stays as it was",
        "Three points take the blocks Q1, Q2 and Q3, two vectors Q1 and Q2, before anything moves. Positions "
        "from here on are unreliable.",
        "G68.2 P2 Q1 X0 Y0 Z0 (then) G00 X10."),
    ig::diagnostic(IG_WARNING, "ISO-0426", "{0} P{1} Q{2} a second time: the last one counts",
                   "One of the blocks that define a plane is there twice. Look for a wrong Q.",
                   "G68.2 P2 Q1 X0 Y0 Z0 (then) G68.2 P2 Q1 X10. Y0 Z0"),
    ig::diagnostic(IG_WARNING, "ISO-0427", "G68.4 without a tilted plane: it counts from the workpiece coordinates",
                   "G68.4 defines a plane inside the one in force. Without one some controls stop with an alarm.",
                   "G68.4 X0 Y0 Z0 J30."),
    ig::diagnostic(IG_ERROR, "ISO-0428", "G68.3 with some of X, Y and Z: name all or none; the plane stays as it was",
                   "They are the origin of the plane; without them it is the place where the tip of the tool stands. "
                   "Positions from here on are unreliable.",
                   "G68.3 X0 Y0"),
    ig::diagnostic(
        IG_ERROR, "ISO-0429", "{0} P{1} Q{2}: there is no such Q; the plane stays as it was",
        "P1 takes the order of the turns (123, 132, 213, 231, 312, 321), P2 the parts 0 to 3, P3 the parts 1 "
        "and 2. Positions from here on are unreliable.",
        "G68.2 P1 Q122 X0 Y0 Z0 I10. J20. K30."),
    ig::diagnostic(IG_ERROR, "ISO-0430", "G68 while a plane is tilted: not executed, the plane stays as it was",
                   "Whether a rotation may stand inside a tilted plane, or ends it, differs from control to control. K "
                   "of G68.2 and R of G68.3 turn the plane in itself. Positions up to G69 are unreliable.",
                   "G68 X0 Y0 R30. (while G68.2 is in force)"),
    ig::diagnostic(IG_ERROR, "ISO-0431", "{0} P{1}: its {2} span no plane; the plane stays as it was",
                   "Three points on a line, two of them the same, a vector of length zero, or angles that project both "
                   "axes to one direction. Positions from here on are unreliable.",
                   "G68.2 P3 Q1 X0 Y0 Z0 I0 J0 K0 (then) G68.2 P3 Q2 K1."),
    ig::diagnostic(
        IG_ERROR, "ISO-0432",
        "{0} P3: the vectors stand at {1} degrees to each other, not at 90; the plane stays as it was",
        "The first vector lies in the plane, the second stands upright on it. Up to 5 degrees are put right, "
        "by turning the first one. Positions from here on are unreliable.",
        "G68.2 P3 Q1 X0 Y0 Z0 I1. J0 K0 (then) G68.2 P3 Q2 I1. J0 K1."),
    ig::diagnostic(IG_WARNING, "ISO-0433", "G68.3: the kinematics of the machine is not known: the tool lies along Z",
                   "The direction of the tool follows from the rotary axes and from the machine (--machine FILE).",
                   "G68.3 (on a machine without MachineKinematics)"),
    ig::diagnostic(IG_WARNING, "ISO-0434", "{0} while {1} is on: its levels count in the new plane from here on",
                   "The R level, the bottom and the initial level keep their numbers, which mean other places now. "
                   "Controls want G80 first; some stop with an alarm.",
                   "G81 X10. Y10. Z-5. R2. F100 (then) G68.2 X0 Y0 Z0 J30."),
};

consteval std::uint32_t tilt_diag(std::string_view code) {
  return index_of(tilt_diagnostics, code, diagnostics.size() + rotary_diagnostics.size());
}

}  // namespace iso
