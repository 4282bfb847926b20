// Diagnostics that several syntaxes of the plugin raise, or a header of theirs: they belong to no single page.
#include <isogloss/sdk.hpp>

namespace iso {
namespace {

const ig::Diagnostics shared_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0101",
                   "'{0}' contains the letter O instead of the digit 0 and is not executed: write the digit",
                   "A code is a letter and a number. The block holds the letter O instead of the digit 0; nothing is "
                   "executed for it. Write the digit.",
                   "GO1 X10."),
    ig::diagnostic(IG_ERROR, "ISO-0103",
                   "'{0}' has two decimal points, so the word is not executed: remove one of them",
                   "The control stops with a format alarm. One of the points is a typing error, and the program cannot "
                   "know which one.",
                   "G01 X-12.8. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0108", "'{0}' is programmed more than once in this block: the last one is used",
                   "The control uses the last word of an address without an alarm, and so does this run.",
                   "G01 X1. X2. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0223", "the tool table has no offset {0}: tool length 0 is assumed",
                   "Add a row to the ToolOffsetTable, or give --tools FILE. Z of this tool is unreliable.", "G43 H77"),
    ig::diagnostic(IG_WARNING, "ISO-0224", "{0} has no H, and no H was programmed before: tool length 0 is assumed",
                   "H names the row of the tool table.", "G43 Z10."),
    ig::diagnostic(IG_ERROR, "ISO-0225", "H{0} is not a valid offset number: the previous tool length stays in force",
                   "An offset number is a whole number, zero or greater. H0 is length 0.", "G43 H1.5"),
    ig::diagnostic(IG_ERROR, "ISO-0266", "{0} of a rotary axis is not executed: the axis keeps its coordinates",
                   "The mirror image acts on X, Y and Z here, not on A, B and C. G10 writes rotary axes only into work "
                   "offsets, and only where the table keeps them. Positions of the axis from here on are unreliable.",
                   "G51.1 A0"),
    ig::diagnostic(IG_ERROR, "ISO-0326", "{0} without Q: the hole is not drilled; program Q, the depth of one peck",
                   "Q, the depth of one peck, must be greater than zero and be programmed in the first block of the "
                   "cycle. A Fanuc control stops with alarm PS0045 where parameter 5103 bit 1 asks for it. The tool "
                   "moves above the hole and to the level at which the cycle would end; it does not enter the hole.",
                   "G83 X10. Y10. Z-20. R2. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0327",
                   "{0} without Q: the hole is drilled in one stroke; program Q, the depth of one peck",
                   "Q, the depth of one peck, must be greater than zero and be programmed in the first block of the "
                   "cycle. The option missing-q of the cycle decides what happens without it.",
                   "G83 X10. Y10. Z-20. R2. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0328", "{0} with a negative Q: its sign is ignored, and the peck is {1} mm",
                   "The control ignores the sign of Q. A negative Q is often a depth that was meant for Z.",
                   "G83 X10. Y10. Z-20. R2. Q-4. F100"),
    ig::diagnostic(
        IG_ERROR, "ISO-0329", "{0} needs {2} pecks of {1} mm for one hole, more than {3}: the hole is not drilled",
        "The option max-pecks of the cycle limits the pecks of one hole, and one block, with all its repeats, makes at "
        "most 100000 steps. A unit or a decimal point of Q or Z is probably wrong. The tool moves above the hole and "
        "to the level at which the cycle would end; it does not enter the hole.",
        "G83 X10. Y10. Z-20. R2. Q0.001 F100"),
    ig::diagnostic(
        IG_ERROR, "ISO-0332", "the transformation from program to machine coordinates of this block cannot be inverted",
        "A frame of this block flattens space, as a tool axis of length 0 does. Positions from here on are unreliable.",
        "a syntax of the chain that writes a frame of zeros"),
    ig::diagnostic(IG_WARNING, "ISO-0333", "{0}: the clearance of {1} mm is not less than the peck of {2} mm: check Q",
                   "Before each peck except the first, the tool feeds through the clearance (G83), or it retracts by "
                   "the clearance (G73): the parameter suits deeper pecks. With such a Q the clearance reaches R or a "
                   "level above it, and the tool cuts air most of the time.",
                   "G83 X10. Y10. Z-20. R2. Q0.5 F100"),
    ig::diagnostic(IG_WARNING, "ISO-0334", "{0}: the machine's {1} is not known: {2} mm is assumed",
                   "The parameter table of the dialect has no value, or a negative one, for the clearance of the peck "
                   "cycle (Fanuc: 5115 for G83, 5114 for G73).",
                   "G83 X10. Y10. Z-20. R2. Q4. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0340", "{0} without an axis word: nothing moves",
                   "G27 to G30 move the axes that their block names. Some controls stop with an alarm. With the option "
                   "without-axes=\"all\", G28 and G30 return every axis.",
                   "G28"),
    ig::diagnostic(IG_WARNING, "ISO-0341", "reference position {0} of axis {1} is not known: machine zero is assumed",
                   "Give the axis a Reference1 (up to Reference4) in the dialect's MachineAxes, or set parameter 1240 "
                   "(up to 1243).",
                   "G91 G28 Z0"),
    ig::diagnostic(
        IG_ERROR, "ISO-0342", "{0} without {1}: the bar is not shifted, and its tip scores the bore",
        "The shift takes the tip off the wall before the bar leaves or enters the bore. Without it the steps are kept, "
        "unshifted: the tool scores the bore, and under G87 it collides on its way in. Program the shift.",
        "G76 X30. Y20. Z-18. R3. F90"),
    ig::diagnostic(IG_WARNING, "ISO-0343", "{0}: Q{1} is negative, and its sign is ignored",
                   "The control uses Q without its sign. The direction of the shift is a setting of the machine.",
                   "G76 X30. Y20. Z-18. R3. Q-0.5 F90"),
    ig::diagnostic(IG_WARNING, "ISO-0344", "{0} without Q: Q{1} of an earlier cycle is used as its {2}, so program Q",
                   "Cycles share one stored Q: the depth of cut of a G83 becomes the shift of a G76, and the bar hits "
                   "the wall. Program Q in the first block of each cycle.",
                   "G83 Z-20. R2. Q8. F90 (then) G76 X30. Z-18."),
    ig::diagnostic(
        IG_WARNING, "ISO-0359", "{0}: {1}{2} is negative, and its sign is ignored because a peck has no sign",
        "I, J and K of a peck cycle are depths of cut and always positive.", "G83 Z-20. R2. I-8. J1. K2. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0372", "{0} has I but no K: pecks do not become smaller than {1} mm",
                   "Each peck is smaller than the one before by J, down to K. Without K the pecks would shrink to "
                   "nothing, so the last size above 0 is kept.",
                   "G83 Z-20. R2. I8. J1. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0383",
                   "{0} while {1} is in force: its words are not transformed, so cancel {1} first",
                   "Polar coordinate command, scaling and mirror image do not act on reference returns, machine "
                   "coordinates and offsets. The control requires them to be cancelled first (G15, G50, G50.1).",
                   "G51 X0 Y0 P500 (then) G91 G28 Z0"),
    ig::diagnostic(IG_ERROR, "ISO-0443",
                   "{0}: the rotary axes cannot point the tool along ({1}, {2}, {3}), so they do not move",
                   "No pair of angles gives the tool this direction, even without the limits of the axes.",
                   "G68.2 X0 Y0 Z0 I0 J90. K0 (then) G53.1"),
    ig::diagnostic(
        IG_ERROR, "ISO-0444", "{0}: the tool direction is outside the travel of the rotary axes, so they do not move",
        "Some pairs of angles give the tool this direction, but none that the block allows lies inside the limits "
        "(MachineAxes). The limits themselves are allowed positions. The control stops with an alarm.",
        "G68.2 X0 Y0 Z0 I0 J90. K0 (then) G53.1"),
    ig::diagnostic(IG_WARNING, "ISO-0461", "{0} has no D, and no D was programmed before: tool radius 0 is assumed",
                   "D names the row of the tool table. The tool centre runs on the contour, not beside it.",
                   "G41 X10. Y10."),
    ig::diagnostic(IG_WARNING, "ISO-0462", "the tool table has no offset {0}: tool radius 0 is assumed",
                   "Add a row to the ToolOffsetTable, or give --tools FILE. The tool centre runs on the contour.",
                   "G41 D77"),
    ig::diagnostic(IG_ERROR, "ISO-0463", "D{0} is not a valid offset number: the previous tool radius stays in force",
                   "An offset number is a whole number, zero or greater. D0 is radius 0: compensation ends.",
                   "G41 D1.5"),
    ig::diagnostic(IG_NOTE, "ISO-0464", "the radius of D{0} is 0: the tool centre runs on the programmed path",
                   "Either the program describes the path of the tool centre and D holds only the wear, or the tool "
                   "table is missing: give --tools FILE. Reported once per run.",
                   "G41 D1 X10."),
    ig::diagnostic(IG_ERROR, "ISO-0478", "G39 is not executed: {0}",
                   "G39 needs a block of its own, under G41 or G42, between two moves in the plane. Without I, J and "
                   "K, the move after it decides where the arc ends.",
                   "G41 ... (then) G39 X10."),
    ig::diagnostic(IG_WARNING, "ISO-0621",
                   "{0} does not fit between its moves, so it is made with {1} mm: program a smaller one",
                   "The chamfer or the rounding needs more of one of the two moves than it has. The control makes it "
                   "smaller without an alarm.",
                   "G1 X10 RND=20"),
    ig::diagnostic(IG_ERROR, "ISO-0480", "{0} is not executed, the corner stays sharp: {1}",
                   "A chamfer (,C) or a rounding (,R) needs a feed move in the plane on each side, both long enough; "
                   "one block without a move may come between them. The tool goes to the corner itself.",
                   "G01 X10. ,C11. F100 (then) Y10."),
    ig::diagnostic(IG_ERROR, "ISO-0493",
                   "this block has more than one jump or call: {0} is not executed, so use separate blocks",
                   "The control requires M98, M99 and M198 to be alone in their block.", "M98 P1000 M99"),
};

}  // namespace
}  // namespace iso
