// Diagnostics that several syntaxes of the plugin raise, or a header that they share: they belong to no page.
#include <isogloss/sdk.hpp>

namespace iso {
namespace {

const ig::Diagnostics shared_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0101", "'{0}': the letter O stands where a zero belongs",
                   "A code is a letter and a number. The block holds the letter O instead of the digit 0; nothing is "
                   "executed for it. Write the digit.",
                   "GO1 X10."),
    ig::diagnostic(IG_ERROR, "ISO-0103", "'{0}' holds two decimal points: the word is not used",
                   "The control stops with a format alarm. One of the points is a typing error, and which one cannot "
                   "be known.",
                   "G01 X-12.8. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0108", "'{0}' stands more than once in this block: the last one counts",
                   "The control lets the last word of an address count without an alarm; so does this run.",
                   "G01 X1. X2. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0201", "more than one code of a modal group in this block: {0} counts",
                   "Codes of one group exclude each other. The control lets the last one count without an alarm; so "
                   "does this run. Remove the others.",
                   "G90 G91 X10."),
    ig::diagnostic(IG_ERROR, "ISO-0210", "F{0}: a feed is greater than zero; the feed of before stays in force",
                   "A control stops at the next feed move with F0 or a negative F. Nothing is written for it here.",
                   "G01 X10. F0"),
    ig::diagnostic(IG_ERROR, "ISO-0211", "a feed move without a feed: {0} ended the one given in {1}, and no F follows",
                   "F200 is 200 mm/min under G94 and 200 mm/rev under G95. Where the dialect says "
                   "mode-change=\"require-f\", changing the mode ends the old feed: program F beside the new mode, or "
                   "before the first feed move. The move is kept, without a feed.",
                   "G95 (F100 before), then G01 X10."),
    ig::diagnostic(IG_WARNING, "ISO-0223", "the tool table has no offset {0}: length 0 is used",
                   "Add a row to the ToolOffsetTable, or give --tools FILE. Z of this tool is unreliable.", "G43 H77"),
    ig::diagnostic(IG_WARNING, "ISO-0224", "{0} without H, and none was programmed before: length 0 is used",
                   "H names the row of the tool table.", "G43 Z10."),
    ig::diagnostic(IG_ERROR, "ISO-0225", "H{0} is no offset number; the tool length of before stays in force",
                   "An offset number is a whole number, zero or greater. H0 is length 0.", "G43 H1.5"),
    ig::diagnostic(
        IG_ERROR, "ISO-0266", "{0} of a rotary axis is not executed: the axis keeps its coordinates",
        "The mirror image acts on X, Y and Z here, not on A, B and C; G10 writes rotary axes into work offsets alone, "
        "where the table keeps them. Positions of the axis from here on are unreliable.",
        "G51.1 A0"),
    ig::diagnostic(
        IG_ERROR, "ISO-0302", "a feed move without a feed: no F is in force",
        "The control stops with an alarm. The move is kept, without a feed: cycle times are wrong. Program F "
        "in this block or before it; under G93 every feed move has an F of its own.",
        "G01 X10. (no F so far)"),
    ig::diagnostic(IG_ERROR, "ISO-0303", "a feed per revolution while no spindle speed is known: the axes stand still",
                   "Under G95 the feed is F times the spindle speed. Program S before the first feed move.",
                   "G95 G01 X10. F0.1 (no S so far)"),
    ig::diagnostic(IG_ERROR, "ISO-0326", "{0} without Q: nothing is drilled",
                   "Q, the depth of one peck, is greater than zero and stands in the first block of the cycle. A Fanuc "
                   "stops with alarm PS0045 where parameter 5103 bit 1 says so. The tool goes over the hole and to the "
                   "level at which the cycle would have left it; it does not enter the hole.",
                   "G83 X10. Y10. Z-20. R2. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0327", "{0} without Q: the hole is drilled in one stroke",
                   "Q, the depth of one peck, is greater than zero and stands in the first block of the cycle. The "
                   "option missing-q of the cycle says what happens without it.",
                   "G83 X10. Y10. Z-20. R2. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0328", "{0} with a negative Q: a peck has no sign; {1} mm is taken",
                   "The control ignores the sign of Q. It is often a depth that was meant to be Z.",
                   "G83 X10. Y10. Z-20. R2. Q-4. F100"),
    ig::diagnostic(
        IG_ERROR, "ISO-0329", "{0} takes {2} pecks of {1} mm for a hole, more than {3}: nothing is drilled",
        "The option max-pecks of the cycle bounds the pecks of one hole, and one block, its repeats included, makes at "
        "most 100000 steps. A unit or a decimal point of Q or Z is probably wrong. The tool goes over the hole and "
        "to the level at which the cycle would have left it; it does not enter the hole.",
        "G83 X10. Y10. Z-20. R2. Q0.001 F100"),
    ig::diagnostic(IG_ERROR, "ISO-0332", "the way from program to machine coordinates cannot be inverted",
                   "A frame of this block flattens space, as a tool axis of length 0 does. Positions from here "
                   "on are unreliable.",
                   "a syntax of the chain that writes a frame of zeros"),
    ig::diagnostic(
        IG_WARNING, "ISO-0333", "{0}: the clearance, {1} mm, is not less than the peck, {2} mm",
        "Before each peck but the first the tool feeds through the clearance (G83), or it goes back by it (G73): the "
        "parameter belongs to deeper pecks. With such a Q the clearance reaches up to R or above it, and the tool cuts "
        "air for most of the time.",
        "G83 X10. Y10. Z-20. R2. Q0.5 F100"),
    ig::diagnostic(IG_WARNING, "ISO-0334", "{0}: the machine's {1} is not known: {2} mm is taken",
                   "The parameter table of the dialect has no value for the clearance of the peck cycle, or a negative "
                   "one (Fanuc: 5115 for G83, 5114 for G73).",
                   "G83 X10. Y10. Z-20. R2. Q4. F100"),
    ig::diagnostic(
        IG_WARNING, "ISO-0336", "the spindle turned counter-clockwise; {0} starts it clockwise",
        "The cycle stops the spindle at the bottom and starts it with M03, whatever it did before. A left-hand "
        "tool cuts backwards from here on, until M04.",
        "M04 S500 G86 X10. Y10. Z-20. R2. F100"),
    ig::diagnostic(IG_ERROR, "ISO-0337", "{0} with P{1}: a dwell is not negative; the cycle does not dwell",
                   "P is the time that the tool waits at the bottom of the hole: seconds, or milliseconds on a Fanuc.",
                   "G82 X10. Y10. Z-20. R2. P-500 F100"),
    ig::diagnostic(IG_WARNING, "ISO-0340", "{0} without an axis: nothing moves",
                   "G27 to G30 move the axes that their block names. Some controls stop with an alarm; where the "
                   "dialect says without-axes=\"all\", G28 and G30 return every axis.",
                   "G28"),
    ig::diagnostic(IG_WARNING, "ISO-0341",
                   "the machine's reference position {0} of {1} is not known: machine zero is taken",
                   "Give the axis a Reference1 (to Reference4) in the dialect's MachineAxes, or parameter 1240 (to "
                   "1243).",
                   "G91 G28 Z0"),
    ig::diagnostic(
        IG_ERROR, "ISO-0342", "{0} without {1}: no shift, the tip of the bar is dragged along the bore",
        "The shift takes the tip off the wall before the bar leaves or enters. Without it the steps are kept, "
        "unshifted: the tool scores the bore, under G87 it collides on its way in. Program the shift.",
        "G76 X30. Y20. Z-18. R3. F90"),
    ig::diagnostic(IG_WARNING, "ISO-0343", "{0}: Q{1}, the sign of Q is ignored",
                   "The control takes Q without its sign. The direction of a shift is the machine's setting.",
                   "G76 X30. Y20. Z-18. R3. Q-0.5 F90"),
    ig::diagnostic(IG_WARNING, "ISO-0344", "{0} without Q: Q{1}, kept from another cycle, is its {2}",
                   "Cycles share one store for Q: the depth of cut of a G83 becomes the shift of a G76, and the bar "
                   "hits the wall. Program Q in the first block of each cycle.",
                   "G83 Z-20. R2. Q8. F90 (then) G76 X30. Z-18."),
    ig::diagnostic(IG_ERROR, "ISO-0352", "{0}: {1} holes of {2} steps are too much for one block; {3} are made",
                   "A block writes at most 100000 steps. Write several blocks, with a smaller K each.",
                   "G91 G87 X1. Z-1. R-1. Q0.1 F90 K10000"),
    ig::diagnostic(
        IG_WARNING, "ISO-0354", "{0}: {1}{2} has no effect in this cycle",
        "The control takes the word without an alarm and keeps it for a later cycle of the same run of holes. "
        "Here nothing comes of it: a Fanuc does not dwell in G73, G81, G83, G85 and G86, whatever P says. G82 "
        "and G89 do.",
        "G83 X10. Y10. Z-20. R2. Q5. P500 F100"),
    ig::diagnostic(IG_WARNING, "ISO-0359", "{0}: {1}{2} is negative: a peck has no sign, the sign is ignored",
                   "I, J and K of a peck cycle are depths of cut and always positive.",
                   "G83 Z-20. R2. I-8. J1. K2. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0372", "{0}: I without K: pecks do not grow smaller than {1} mm",
                   "Each peck is J less than the one before, down to K. Without K they would come to nothing; the last "
                   "size above 0 is kept.",
                   "G83 Z-20. R2. I8. J1. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0383", "{0} while {1} is in force: its words are taken as they are",
                   "Polar command, scaling and mirror image do not act on reference returns, machine coordinates and "
                   "offsets. The control wants them cancelled first (G15, G50, G50.1).",
                   "G51 X0 Y0 P500 (then) G91 G28 Z0"),
    ig::diagnostic(IG_ERROR, "ISO-0401", "{0}: the machine has no such axis; the word moves nothing",
                   "The rows of MachineAxes (--machine FILE), or the parameters of the control, say which axes there "
                   "are. The word is not used; the other words of its block are.",
                   "G01 B30. F100"),
    ig::diagnostic(IG_NOTE, "ISO-0402", "no machine says which rotary axes there are: A, B and C turn without limits",
                   "They are taken as axes that turn on and on, by the shortest way to a position. Said once. Give "
                   "--machine FILE with a MachineAxes row for each axis.",
                   "G00 A90."),
    ig::diagnostic(IG_ERROR, "ISO-0404", "{0} {1}: no rotary axis has such a position; the axis stays where it is",
                   "Angles are counted up to a thousand million degrees.", "G00 A1e10"),
    ig::diagnostic(IG_ERROR, "ISO-0443",
                   "{0}: the rotary axes cannot turn the tool to {1}, {2}, {3}: they stay where they are",
                   "No pair of angles, whatever the limits of the axes are, gives the tool this direction.",
                   "G68.2 X0 Y0 Z0 I0 J90. K0 (then) G53.1"),
    ig::diagnostic(IG_ERROR, "ISO-0444", "{0}: outside the travel of the rotary axes, so they stay where they are",
                   "Of the pairs of angles that give the tool its direction, none that the block allows lies inside "
                   "the limits (MachineAxes). Limits are inclusive. The control stops with an alarm.",
                   "G68.2 X0 Y0 Z0 I0 J90. K0 (then) G53.1"),
    ig::diagnostic(IG_WARNING, "ISO-0461", "{0} without D, and none was programmed before: radius 0 is used",
                   "D names the row of the tool table. The tool runs on the contour, not beside it.", "G41 X10. Y10."),
    ig::diagnostic(IG_WARNING, "ISO-0462", "the tool table has no offset {0}: radius 0 is used",
                   "Add a row to the ToolOffsetTable, or give --tools FILE. The tool runs on the contour.", "G41 D77"),
    ig::diagnostic(IG_ERROR, "ISO-0463", "D{0} is no offset number; the radius of before stays in force",
                   "An offset number is a whole number, zero or greater. D0 is radius 0: compensation ends.",
                   "G41 D1.5"),
    ig::diagnostic(IG_NOTE, "ISO-0464", "the radius of D{0} is 0: the tool runs on the programmed path",
                   "Either the program holds the path of the tool's centre and D its wear, or the tool table was not "
                   "given: --tools FILE. Said once a run.",
                   "G41 D1 X10."),
    ig::diagnostic(IG_ERROR, "ISO-0478", "G39 is not executed: {0}",
                   "G39 stands alone in its block, under G41 or G42, between two moves in the plane; without I J K the "
                   "move behind it says where the arc ends.",
                   "G41 ... (then) G39 X10."),
    ig::diagnostic(
        IG_ERROR, "ISO-0480", "{0} is not executed, the corner stays sharp: {1}",
        "A chamfer (,C) or a rounding (,R) stands between two feed moves in the plane, which are both long "
        "enough for it; one block without a move may stand between them. The tool goes to the corner itself.",
        "G01 X10. ,C11. F100 (then) Y10."),
    ig::diagnostic(IG_ERROR, "ISO-0493", "this block asks for more than one jump or call: {0} is not executed",
                   "The control wants M98, M99 and M198 alone in their block.", "M98 P1000 M99"),
};

}  // namespace
}  // namespace iso
