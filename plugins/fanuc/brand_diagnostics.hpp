/// Diagnostics of the controls that descend from Fanuc's. The part of the plugin's table that follows
/// macro_diagnostics.hpp.
#pragma once

#include "macro_diagnostics.hpp"

namespace fanuc {

inline constexpr std::array brand_diagnostics{
    ig::diagnostic(IG_ERROR, "FAN-0201", "{0} is not executed: {1}",
                   "The control has this function, but it is recognised here only. The words that belong to it go with "
                   "it, so that they are not taken for a move.",
                   "G13 I5. D1 F200"),
    ig::diagnostic(
        IG_WARNING, "FAN-0202", "D{0} of a canned cycle has no effect: the feed does not change on the way",
        "On a Mazak D is the distance at which the feed of a cycle changes. The hole is drilled at one feed.",
        "G81 X10. Z-20. R2. D3. F100"),
    ig::diagnostic(
        IG_ERROR, "FAN-0203", "M53 is not executed: the cycle returns to {0}, where it began",
        "On an Okuma a cycle with M53 returns to the level of G71. That is done where the tool stands at this "
        "level when the cycle begins; here it stands elsewhere, or no G71 came before.",
        "G71 Z100 (then, at Z50) G81 X10 Z-20 R5 F200 M53"),
    ig::diagnostic(IG_WARNING, "FAN-0204", "{0} without an axis: nothing is mirrored",
                   "G101 mirrors the axes that its block names, each at the work zero; the value of the word does not "
                   "count.",
                   "G101"),
    ig::diagnostic(
        IG_WARNING, "FAN-0205", "{0}: nothing is measured here, {1} keeps its value",
        "On the machine a probe ends the move and the control writes what it measured. Here the move goes to "
        "its end, and blocks after it see the offset of before.",
        "G36 Y-0.7 F10."),
    ig::diagnostic(
        IG_WARNING, "FAN-0206",
        "G47: the strokes of the text are not shown: it begins at X{0} Y{1}, {2} mm high, at an angle of {3} "
        "degrees; the tool is taken to stay over its beginning{4}",
        "The letters are a font of the control. The tool goes to the place where the text begins and to R, so "
        "that Z is right afterwards; X and Y are where the last letter ends, which the font decides. A block "
        "with X and Y under G90 makes them right again.",
        "G47 P0 (TEXT) X2. Y2. I45. J5. R1. Z-0.1 F150. E100."),
    ig::diagnostic(
        IG_WARNING, "FAN-0207",
        "G150: the pocket of program {0}, down to Z{1}, is not milled here; the tool is taken to stand over "
        "its start",
        "How the control clears the contour of its subprogram is not known exactly. The tool goes to the "
        "start of the pocket and to R. G40 and an X Y move, which follow as a rule, make the position right again.",
        "G150 P61502 X3.25 Y4.5 Z-1.5 G41 J0.35 K0.01 Q0.25 R0.1 D1 F15."),
    ig::diagnostic(IG_WARNING, "FAN-0208", "G141: D{0} has no radius here, so nothing is compensated up to G40",
                   "Compensation in space is not executed. With the radius 0 the path is right as it is programmed; "
                   "the machine's own radius shifts it.",
                   "G141 D1 X0. Y0. Z0."),
    ig::diagnostic(
        IG_ERROR, "FAN-0209", "rotary axes have turned under G254: the work offset stays where it was",
        "G255 ends G254 before the rotary axes turn, and G254 comes again when they stand. The work offset is "
        "that of the angles at which G254 came.",
        "G254 (then) G00 B45."),
    ig::diagnostic(
        IG_ERROR, "FAN-0210", "{0} P{1} is not executed: {2}",
        "G54.2 adds a fixture offset and turns it with the table; it is 0 where the workpiece is set on the "
        "centre of the table. G54.4 shifts and turns positions by a measured setting error. Up to P0 positions "
        "lack that.",
        "G54.2 P1"),
    ig::diagnostic(IG_ERROR, "FAN-0211", "{0} without P: nothing is chosen",
                   "P0 cancels, P1 and up choose a row of the control's table.", "G54.2"),
    ig::diagnostic(IG_WARNING, "FAN-0212",
                   "G143: H{0} has no length here, so nothing is added along the tool up to G49",
                   "The length on five axes is not executed. With the length 0 the positions are right as they are "
                   "programmed; the machine's own length shifts them along the turned tool.",
                   "G143 H1 X0. Y0. Z20. A-10. B5."),
    ig::diagnostic(IG_ERROR, "FAN-0220", "{0} is not executed: {1}; the block moves without the tool offset",
                   "G45 to G48 lengthen or shorten the ways of their block by the offset of D. Positions are wrong by "
                   "the offset from here on, up to a block without G45 to G48 under G90.",
                   "G45 X10. (without a D)"),
    ig::diagnostic(IG_WARNING, "FAN-0221", "{0} is ignored: a canned cycle is in force; write it before the cycle",
                   "The control ignores G45 to G48 in the mode of canned cycles. G80 ends it.",
                   "G81 Z-10. R2. F100 / G45 X10. D1"),
    ig::diagnostic(IG_WARNING, "FAN-0222",
                   "{0}: the radius of D{1} is 0 in the tool table, so the offset changes nothing",
                   "Give the row with --tools, or one value with --set ToolOffsetTable.1.D=5.", "G45 X10. D99"),
    ig::diagnostic(IG_ERROR, "FAN-0223",
                   "{0}: only a quarter or three quarters of a circle with I J K take the offset; the arc has none",
                   "The manual allows G45 to G48 in an arc that begins and ends on the axes of its centre, without R, "
                   "and not under G68; the radius must stay greater than 0.",
                   "G03 G45 X10. Y20. R20. D1"),
};

consteval std::uint32_t brand_diag(std::string_view code) {
  return iso::index_of(brand_diagnostics, code, macro_diagnostics.size());
}

}  // namespace fanuc
