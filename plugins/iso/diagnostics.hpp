/// The plugin's table of diagnostics: code, severity, text, explanation, an example that provokes it. The reference
/// page and `isogloss explain CODE` come from it. Codes are never reused.
#pragma once

#include "diagnostic_index.hpp"

namespace iso {

inline constexpr std::array diagnostics{
    // parsing: 100–199
    ig::diagnostic(IG_ERROR, "ISO-0101", "'{0}': the letter O stands where a zero belongs",
                   "A code is a letter and a number. The block holds the letter O instead of the digit 0; nothing is "
                   "executed for it. Write the digit.",
                   "GO1 X10."),
    ig::diagnostic(IG_ERROR, "ISO-0102", "'{0}' has no number: nothing is executed for it",
                   "A code is a letter and a number.", "G X10."),
    ig::diagnostic(IG_ERROR, "ISO-0103", "'{0}' holds two decimal points: the word is not used",
                   "The control stops with a format alarm. One of the points is a typing error, and which one cannot "
                   "be known.",
                   "G01 X-12.8. F100"),
    ig::diagnostic(IG_ERROR, "ISO-0104", "'{0}' has no number: write its value, or remove the address",
                   "A word is an address and a number. An empty word is often a placeholder that a post processor "
                   "did not fill.",
                   "G99 G82 R2. Z-3. P F15."),
    ig::diagnostic(IG_ERROR, "ISO-0105", "'{0}' holds two signs: the word is not used",
                   "A number has one sign. For a computed value write brackets: X-[-1.].", "G01 X--1. F100"),
    ig::diagnostic(IG_ERROR, "ISO-0106", "'{0}' is written with an exponent: write the number out",
                   "Part programs know no exponents; E would be an address of its own. Spreadsheets and scripts write "
                   "such numbers.",
                   "G01 X1E-3 F100"),
    ig::diagnostic(IG_ERROR, "ISO-0107", "'{0}' holds a decimal comma: write a point",
                   "Part programs know the decimal point only, in every country.", "G01 X1,5 F100"),
    ig::diagnostic(IG_WARNING, "ISO-0108", "'{0}' stands more than once in this block: the last one counts",
                   "The control lets the last word of an address count without an alarm; so does this run.",
                   "G01 X1. X2. F100"),
    ig::diagnostic(IG_ERROR, "ISO-0109", "'{0}' is a number without an address: nothing is executed for it",
                   "Every number of a block belongs to the letter before it. Look for a letter that was lost (G, X), "
                   "or for a program number that begins with a zero instead of the letter O.",
                   "N10 21 G40"),
    ig::diagnostic(IG_ERROR, "ISO-0110", "'{0}' is no word of this dialect: nothing is executed for it",
                   "An address is one letter. Names, statements and calls belong to other dialects; the words behind a "
                   "name are not executed either. Comments stand in parentheses.",
                   "CYCLE81(50,0,2,-20)"),
    ig::diagnostic(IG_ERROR, "ISO-0111", "the comment that begins here is not closed: the rest of the block is skipped",
                   "A comment ends at the first closing parenthesis of its block.", "G00 X10. (hole 1"),
    ig::diagnostic(IG_NOTE, "ISO-0112", "text beside the tape mark is skipped: '{0}'",
                   "The control skips what stands between the first % and the end of its line, and all that follows "
                   "the second %.",
                   "% PART 17"),
    ig::diagnostic(IG_WARNING, "ISO-0113", "another program, {0}, begins here: the run ends before it",
                   "A file may hold several programs; the control does not run from one into the next. Select another "
                   "one with --program.",
                   "O2000"),
    ig::diagnostic(IG_WARNING, "ISO-0114", "{0} does not stand first in its block",
                   "The control wants the sequence number before all words of the block. It is taken all the same.",
                   "G00 N10 X5."),
    ig::diagnostic(IG_WARNING, "ISO-0115", "{0}{1} has no decimal point: read as {2} {3}",
                   "Whether a number without a point means units or least increments is a setting of the control "
                   "(Fanuc: parameter 3401 bit 0). Programs that write the point mean the same on all of them.",
                   "G00 X100"),
    ig::diagnostic(IG_ERROR, "ISO-0116", "'{0}' cannot be read as a number: the word is not used",
                   "The value of a word is digits with at most one point and one sign before them.", "G01 X1O.5 F100"),
    ig::diagnostic(IG_ERROR, "ISO-0117", "{0}: too large a number of inches: the word is not used",
                   "In millimetres it is beyond every number that can be counted in.", "G20 G01 X99999999... F1."),
    // modal state, tables, program flow, inspection: 200–299
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
    ig::diagnostic(IG_ERROR, "ISO-0212", "S{0}: a spindle speed is not negative; the speed of before stays in force",
                   "The direction comes from M03 and M04, never from the sign of S.", "M03 S-500"),
    ig::diagnostic(IG_ERROR, "ISO-0213", "T{0} is no tool number",
                   "A tool number is a whole number, zero or greater. The word is not used.", "T1.5 M06"),
    ig::diagnostic(IG_WARNING, "ISO-0214", "M06, but no T named a tool so far: which tool is in the spindle is unknown",
                   "Name the tool in this block or in one before it.", "M06"),
    ig::diagnostic(IG_ERROR, "ISO-0215", "G04: a dwell of {0} s is no time; the block does not dwell",
                   "The time of a dwell is zero or greater.", "G04 X-1."),
    ig::diagnostic(IG_WARNING, "ISO-0216", "G04 has more than one time: {0} counts",
                   "X, U and P of G04 mean the same time. The first of them, in this order, counts.", "G04 X1. P500"),
    ig::diagnostic(IG_ERROR, "ISO-0220", "G10 L{0} is not executed: the table keeps its values",
                   "L2 and L20 (work offsets), L10 to L13 (tool offsets) are executed. Parameters (L50) and other "
                   "data are not: what depends on them is unreliable from here on.",
                   "G10 L50"),
    ig::diagnostic(IG_ERROR, "ISO-0221", "G10 without {0}: the table keeps its values",
                   "G10 needs L (which table) and P (which row); L10 to L13 need R, the value.", "G10 L2 X10."),
    ig::diagnostic(IG_ERROR, "ISO-0222", "G10 L{0} P{1}: there is no such row; the table keeps its values",
                   "L2 has P0 (external offset) and P1 to P6 (G54 to G59); L20 has P1 and up (G54.1 P1 ...), as far as "
                   "the dialect's IsoCoordinateTable goes; L10 to L13 have P1 and up.",
                   "G10 L2 P7 X0"),
    ig::diagnostic(IG_WARNING, "ISO-0223", "the tool table has no offset {0}: length 0 is used",
                   "Add a row to the ToolOffsetTable, or give --tools FILE. Z of this tool is unreliable.", "G43 H77"),
    ig::diagnostic(IG_WARNING, "ISO-0224", "{0} without H, and none was programmed before: length 0 is used",
                   "H names the row of the tool table.", "G43 Z10."),
    ig::diagnostic(IG_ERROR, "ISO-0225", "H{0} is no offset number; the tool length of before stays in force",
                   "An offset number is a whole number, zero or greater. H0 is length 0.", "G43 H1.5"),
    ig::diagnostic(IG_ERROR, "ISO-0226", "there is no work offset {0}; {1} stays in force",
                   "The dialect's IsoCoordinateTable has no such set. Positions from here on are unreliable.",
                   "G54.1 P999"),
    ig::diagnostic(IG_WARNING, "ISO-0230", "M99 in the main program: the run ends here",
                   "The control jumps to the start of the program and runs it again, until someone stops it. `isogloss "
                   "run --main-passes` lets it run several times here.",
                   "M99"),
    // ISO-0260 was radius compensation, before it was executed.
    ig::diagnostic(
        IG_ERROR, "ISO-0263", "{0} is not executed: the frame is not rotated",
        "A rotation about an axis in space (G68 with I, J, K) is recognised only. Positions up to G69 are unreliable; "
        "G68.2 defines a tilted plane.",
        "G68 X0 Y0 Z0 I0 J1. K0 R30."),
    ig::diagnostic(
        IG_ERROR, "ISO-0265", "{0} is not executed: the tool length of before stays in force",
        "Compensation along the tool's present direction (G43.1) is recognised only. Positions are unreliable "
        "up to G49.",
        "G43.1 H1"),
    ig::diagnostic(
        IG_ERROR, "ISO-0266", "{0} of a rotary axis is not executed: the axis keeps its coordinates",
        "The mirror image acts on X, Y and Z here, not on A, B and C; G10 writes rotary axes into work offsets alone, "
        "where the table keeps them. Positions of the axis from here on are unreliable.",
        "G51.1 A0"),
    ig::diagnostic(IG_ERROR, "ISO-0267", "{0} is not executed: its move is left out",
                   "The tool stays where it is. The position is unreliable until every axis is programmed in G90.",
                   "G37 H1 Z0"),
    ig::diagnostic(IG_ERROR, "ISO-0268", "{0} is not executed: the macro is not called, its words are not used",
                   "Macro calls are recognised only. What the macro would move or change is missing from here on.",
                   "G65 P9010 A1."),
    ig::diagnostic(IG_ERROR, "ISO-0269", "{0} is not executed: the subprogram is not called",
                   "Subprograms are recognised only. What the subprogram would move or change is missing from here "
                   "on.",
                   "M98 P1000"),
    ig::diagnostic(IG_ERROR, "ISO-0270", "{0} is not executed: X, Y and C are taken as they are",
                   "Polar (G12.1) and cylindrical (G07.1) interpolation are recognised only. Positions up to G13.1 or "
                   "G07.1 C0 are unreliable.",
                   "G12.1"),
    ig::diagnostic(IG_ERROR, "ISO-0272", "{0} is not executed: the forbidden zone is not watched",
                   "The stored stroke check is recognised only. Moves into the zone are not reported.",
                   "G22 X100. Y100. Z50. I0 J0 K0"),
    ig::diagnostic(IG_ERROR, "ISO-0280", "{0} is unknown here and not executed",
                   "No syntax of the dialect knows this G code. What it would move or change is missing: positions are "
                   "unreliable from here on.",
                   "G199"),
    ig::diagnostic(IG_WARNING, "ISO-0281", "{0} is unknown here and not executed",
                   "No syntax of the dialect knows this M code; most M codes are the machine builder's own.", "M123"),
    ig::diagnostic(IG_ERROR, "ISO-0282", "{0} is not executed in this block, nor are its words",
                   "The dialect knows the code, but no syntax answered it here. What it would move or change is "
                   "missing: positions are unreliable from here on.",
                   "G84 X10. Z-10. R2. F500 (in a dialect without TappingCycleSyntax)"),
    ig::diagnostic(IG_WARNING, "ISO-0283", "{0} is not executed in this block",
                   "The dialect knows the M code, but no syntax answered it here.", "M98"),
    ig::diagnostic(IG_ERROR, "ISO-0284", "{0} is used by nothing in this block",
                   "An axis, arc or cycle word was programmed that no function of the block takes: the move that it "
                   "belongs to is missing or differs. Positions are unreliable from here on.",
                   "G91 G53 X10."),
    ig::diagnostic(IG_WARNING, "ISO-0285", "{0} is used by nothing in this block",
                   "The word has no function in this block; on a control it may be an alarm.", "D5"),
    ig::diagnostic(IG_ERROR, "ISO-0286", "{0} is not evaluated: the word has no value",
                   "Variables and expressions are recognised only. The word counts as not programmed: positions are "
                   "unreliable from here on.",
                   "G01 X#1"),
    ig::diagnostic(IG_ERROR, "ISO-0287", "'{0}' is not executed",
                   "Macro statements and program flow are recognised only. Everything after it may differ from what "
                   "the control does.",
                   "IF [#1 GT 0] GOTO 10"),
    ig::diagnostic(IG_NOTE, "ISO-0288", "'{0}' is no part of a program that the dialect knows",
                   "Nothing reads this text. It changes nothing.", "& leftover text"),
    // cycles, motion, frames: 300–399
    ig::diagnostic(
        IG_ERROR, "ISO-0302", "a feed move without a feed: no F is in force",
        "The control stops with an alarm. The move is kept, without a feed: cycle times are wrong. Program F "
        "in this block or before it; under G93 every feed move has an F of its own.",
        "G01 X10. (no F so far)"),
    ig::diagnostic(IG_ERROR, "ISO-0303", "a feed per revolution while no spindle speed is known: the axes stand still",
                   "Under G95 the feed is F times the spindle speed. Program S before the first feed move.",
                   "G95 G01 X10. F0.1 (no S so far)"),
    ig::diagnostic(IG_WARNING, "ISO-0310", "{0} and {1} stand in one block: {2}, the later one, counts",
                   "A motion code of group 01 ends a canned cycle, a cycle code starts one. Manuals advise not to rely "
                   "on their order in one block. When the motion counts, X, Y and Z are moved by it and F is its feed.",
                   "G01 G81 X10. Z-5. R2. F100"),
    ig::diagnostic(IG_ERROR, "ISO-0311",
                   "{0} without {1}, and none was programmed since the cycle began: nothing is drilled",
                   "The first block of a cycle names the bottom and the R level; later blocks may leave them out.",
                   "G81 X10. Y10. F100"),
    ig::diagnostic(IG_WARNING, "ISO-0312",
                   "{0} without {1}, and none was programmed since the cycle began: the tool's position counts",
                   "The first block of a cycle names the bottom and the R level; later blocks may leave them out. "
                   "Controls differ on what a missing one is.",
                   "G81 X10. Y10. Z-5. F100"),
    ig::diagnostic(IG_ERROR, "ISO-0313", "{0}{1}: a count of holes is a whole number from 0; one hole is drilled",
                   "K (or L) says how often the block repeats its cycle; K0 keeps the data and drills nothing.",
                   "G91 G81 X10. Z-5. R-2. K2.5"),
    ig::diagnostic(IG_ERROR, "ISO-0314", "{0}{1}: more holes than a block may drill; {2} are drilled",
                   "The option max-repeats of CannedCycleResolveSyntax bounds what one block can do.",
                   "G91 G81 X0.1 Z-5. R-2. K99999"),
    ig::diagnostic(IG_WARNING, "ISO-0315", "K and L in one block: K counts the holes",
                   "Both are repeats of a canned cycle, of different controls. Remove one of them.",
                   "G91 G81 X10. Z-5. R-2. K2 L3 F100"),
    ig::diagnostic(IG_ERROR, "ISO-0320", "an arc without a centre: it needs I, J, K or R in its own block",
                   "The control stops with an alarm (Fanuc parameter 3403 bit 5). The tool goes straight to the end of "
                   "the arc here.",
                   "G02 X10. Y10."),
    ig::diagnostic(
        IG_ERROR, "ISO-0321", "the arc starts {0} mm from its centre and ends {1} mm from it: more than {2} apart",
        "The end does not lie on the circle of the start. The control stops with an alarm. The radius changes "
        "evenly along the arc here.",
        "G02 X10. Y10. I5.1"),
    ig::diagnostic(IG_ERROR, "ISO-0322",
                   "R{0} does not reach the end of the arc: {1} is the least; half a circle is taken",
                   "Start and end lie more than twice the radius apart. The control stops with an alarm.",
                   "G90 G02 X50. R20. (from X0)"),
    ig::diagnostic(IG_WARNING, "ISO-0323", "an arc with R whose end is its start: no arc is made",
                   "Infinitely many circles go through one point. For a whole circle program I, J or K.", "G02 R10."),
    ig::diagnostic(
        IG_ERROR, "ISO-0324", "the centre of the arc is its start: no arc is made",
        "I, J and K are distances from the start to the centre, also under G90. All are 0 here; the tool goes "
        "straight to the end.",
        "G02 X10. I0 J0"),
    ig::diagnostic(IG_WARNING, "ISO-0325", "R and a centre (I, J, K) stand in one block: R counts",
                   "The control ignores I, J and K where R is programmed.", "G02 X10. R5. I5."),
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
    ig::diagnostic(
        IG_WARNING, "ISO-0330", "G53 under G91 is ignored: nothing moves",
        "Machine coordinates are positions; the control ignores G53 while G91 is in force. Its axis words are "
        "not used.",
        "G91 G53 Z0"),
    ig::diagnostic(IG_NOTE, "ISO-0331", "G53 without an axis: nothing moves",
                   "G53 acts on the axis words of its block alone.", "G53"),
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
        IG_NOTE, "ISO-0335", "{0}: at the bottom the control waits for the operator",
        "The operator draws the tool out of the hole by hand and presses cycle start. The run goes on with a "
        "rapid to R, marked as manual; the time at the bottom is the operator's. Said in the first block of "
        "a run of holes.",
        "G88 X10. Y10. Z-20. R2. F100"),
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
    ig::diagnostic(
        IG_WARNING, "ISO-0338", "the plane changes while {0} is on: its R and bottom are forgotten",
        "They lie on the axis along which the tool worked before. Fanuc wants G80 before the drilling axis changes. "
        "Name both anew; the initial level is the position on the new axis.",
        "G18 X20. (while G81 is on)"),
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
    ig::diagnostic(IG_ERROR, "ISO-0345", "G87 under G99: the tool returns to the initial level all the same",
                   "R of back boring lies below the workpiece; only G98 is legal. The control stops with an alarm.",
                   "G99 G87 X30. Y20. Z-25. R-45. Q4. F60"),
    ig::diagnostic(
        IG_ERROR, "ISO-0346", "G87: {0} is {1}, not below {2}, which is {3}: the cut does not go upward",
        "Back boring enters through the bore and cuts upward. On Fanuc R is the low end of the cut and Z the "
        "high one; other manuals have it the other way round. The steps are kept as programmed.",
        "G87 X30. Y20. Z-45. R-25. Q4. F60 (r-is bottom)"),
    ig::diagnostic(
        IG_WARNING, "ISO-0347", "{0} while the spindle direction is {1}: the tap enters {2}",
        "A tapping cycle reverses the spindle and restores it, but does not start it. Program M03 before G84, "
        "M04 before G74; also after rigid tapping, which leaves the spindle stopped.",
        "M05 (then) G84 X30. Y20. Z-15. R5. F750"),
    ig::diagnostic(IG_WARNING, "ISO-0348", "{0}: Q is the depth of cut of rigid tapping only and is not used",
                   "With a floating holder the tap goes to the bottom in one stroke. M29 before the cycle, or the "
                   "machine's parameter, makes it rigid.",
                   "G84 X30. Y20. Z-15. R5. Q8. F750"),
    ig::diagnostic(IG_ERROR, "ISO-0349", "rigid tapping without a spindle speed",
                   "Axis and spindle turn together: no S, no thread. Program S with M29.",
                   "M29 (no S so far, then) G84 X30. Y20. Z-15. R5. F750"),
    ig::diagnostic(
        IG_ERROR, "ISO-0350", "{0} between M29 and the tapping cycle",
        "After M29 the control wants the tapping cycle next: no S, no spindle code, no axis move (Fanuc alarms "
        "PS0203, PS0204). The block is executed all the same.",
        "M29 S500 (then) X10."),
    ig::diagnostic(IG_ERROR, "ISO-0351", "{0}: Q{1} gives more than {2} cuts; the last one goes to the bottom at once",
                   "The option max-pecks bounds what one hole can do. Q is most likely too small by a factor.",
                   "M29 S500 (then) G84 X30. Y20. Z-15. R5. Q0.0001 F750"),
    ig::diagnostic(IG_ERROR, "ISO-0352", "{0}: {1} holes of {2} steps are too much for one block; {3} are made",
                   "A block writes at most 100000 steps. Write several blocks, with a smaller K each.",
                   "G91 G87 X1. Z-1. R-1. Q0.1 F90 K10000"),
    ig::diagnostic(IG_WARNING, "ISO-0353", "{0}: the retract of {1} mm is longer than the depth of cut Q{2}",
                   "Peck tapping withdraws the tap by the machine's setting after each cut, here beyond the R level.",
                   "M29 S500 (then) G84 X30. Y20. Z-15. R5. Q0.5 F750 (retract of 1 mm)"),
    ig::diagnostic(IG_ERROR, "ISO-0360", "G68 without R, and no angle is known for it: the frame keeps its rotation",
                   "R is the angle in degrees. A Fanuc takes parameter 5410 where R is missing; this dialect has no "
                   "such parameter. Positions up to G69 are unreliable.",
                   "G68 X0 Y0"),
    ig::diagnostic(IG_WARNING, "ISO-0361", "G68 without R: the control's parameter counts, {0} degrees",
                   "Fanuc parameter 5410. The program turns by another angle on the next machine: write R.",
                   "fanuc: G68 X0 Y0"),
    ig::diagnostic(
        IG_WARNING, "ISO-0362", "R{0}: an angle of rotation lies between -360 and 360; whole turns are left out",
        "The control may stop with an alarm. Without a decimal point R counts thousandths of a degree on some "
        "controls, whole degrees on others.",
        "G68 X0 Y0 R400."),
    ig::diagnostic(IG_ERROR, "ISO-0363", "G68: the centre lies too far away; the frame keeps its rotation",
                   "The rotation about this centre cannot be computed. Look for a typing error in its words.",
                   "G68 R180. Y0 X1 with 308 zeros after it"),
    ig::diagnostic(
        IG_WARNING, "ISO-0364", "{0} while the coordinates are rotated: cancel the rotation by G69 first",
        "Controls forbid reference returns, other coordinate systems and another plane while G68 is in force: "
        "an alarm, or positions that nobody wants. Here the rotation stays what it is, in its own plane and "
        "with its centre in program coordinates, and the code does what it does without a rotation.",
        "G55 (while G68 is in force)"),
    ig::diagnostic(
        IG_WARNING, "ISO-0365", "{0} without an axis: no coordinate system is set",
        "G92 gives the present position of the axes that it names new coordinates. With S alone it limits the "
        "speed of the spindle.",
        "G92"),
    ig::diagnostic(IG_WARNING, "ISO-0366", "G92.1 {0}{1}: the value is not used; the shift of the axis ends",
                   "The word names the axis, and manuals write it with 0. For another position program G92.",
                   "G92.1 X5."),
    ig::diagnostic(
        IG_ERROR, "ISO-0367", "{0} is no work coordinate system of this control; {1} stays in force",
        "Fanuc has G54 to G59 and G54.1 P1 and up; G59.1 to G59.9 are other makers'. Positions from here on are "
        "unreliable.",
        "fanuc: G59.1"),
    ig::diagnostic(IG_NOTE, "ISO-0368", "G54.1 without P: P1 counts",
                   "The control takes the first additional coordinate system. Write P1 where it is meant.", "G54.1"),
    ig::diagnostic(IG_ERROR, "ISO-0369", "{0}: the shift cannot be computed; the coordinate systems stay as they are",
                   "The position is too large a number. Positions from here on are unreliable.",
                   "G92 X-1 (after G92 X1), each with 308 zeros after it"),
    ig::diagnostic(
        IG_ERROR, "ISO-0370", "G92 S{0}: a limit of the spindle speed is not negative; the limit of before stays",
        "S of G92 is the highest speed, in revolutions a minute, that the spindle may reach under G96.", "G92 S-100"),
    ig::diagnostic(
        IG_WARNING, "ISO-0371", "a parameter of the control is not written: {0} is not used",
        "Between G10 L50 and G11 a block names a parameter by N and its value by R (and an axis by P). They are "
        "no sequence number and no motion. What depends on the parameter is unreliable from here on.",
        "G10 L50 (next block) N5410 R30000"),
    ig::diagnostic(IG_ERROR, "ISO-0380", "G30 P{0}: there is no such reference position; nothing moves",
                   "G30 goes to reference position 2, 3 or 4; without P to the second. G28 goes to the first.",
                   "G91 G30 P5 Z0"),
    ig::diagnostic(IG_WARNING, "ISO-0381", "G29 {0}: no G28 or G30 left an intermediate point; it goes straight",
                   "G29 goes over the intermediate point of the last G28 or G30 that named the axis. None did so far: "
                   "the tool may take another way than on the control.",
                   "G29 X10. (no G28 X so far)"),
    ig::diagnostic(IG_ERROR, "ISO-0382", "G27: {0} stands at {1}, not at its reference position {2}",
                   "G27 checks that its point is the first reference position; the control stops with an alarm "
                   "(PS0092). Look for an offset that is still in force.",
                   "G27 X10."),
    ig::diagnostic(IG_WARNING, "ISO-0383", "{0} while {1} is in force: its words are taken as they are",
                   "Polar command, scaling and mirror image do not act on reference returns, machine coordinates and "
                   "offsets. The control wants them cancelled first (G15, G50, G50.1).",
                   "G51 X0 Y0 P500 (then) G91 G28 Z0"),
    ig::diagnostic(IG_ERROR, "ISO-0384", "an arc under G16 needs R: its centre would be taken as a length",
                   "While radius and angle are programmed, the control takes arcs with R only.",
                   "G16 (then) G02 X10. Y90. I5. J0"),
    ig::diagnostic(IG_ERROR, "ISO-0385", "repeats with a radius from the tool lie on a straight line here",
                   "Where the dialect says incremental-radius=\"from-position\", a radius under G91 makes the tool the "
                   "pole. Repeats of a cycle (K, L) are not turned then. Program the holes one by one.",
                   "G91 G16 (then) G81 X10. Y30. Z-5. R-2. F100 K3"),
    ig::diagnostic(IG_ERROR, "ISO-0386", "G51 {0}{1}: there is no such factor; scaling stays as it was",
                   "A factor counts from 1 to 999999 thousandths (or hundred-thousandths, parameter 5400 bit 7); I, J "
                   "and K may be negative.",
                   "G51 X0 Y0 P0"),
    ig::diagnostic(IG_WARNING, "ISO-0387", "G51 without P, I, J and K: the factor is 1",
                   "The control takes parameter 5411, which the dialect does not know.", "G51 X0 Y0"),
    ig::diagnostic(IG_WARNING, "ISO-0388", "G51.1 without an axis: nothing is mirrored",
                   "G51.1 mirrors the axes that its block names, each at the position of its word.", "G51.1"),
    ig::diagnostic(IG_WARNING, "ISO-0389", "G96: the spindle speed in revolutions is not known up to G97 with S",
                   "Under constant surface speed it follows from the position of an axis, which is not computed. "
                   "Feeds per revolution and threads have no speed until then.",
                   "G96 S200"),
    ig::diagnostic(IG_NOTE, "ISO-0390", "G31: no skip signal comes here, the move goes to its end",
                   "On the machine the signal of a probe ends the move; what the program computes from the place "
                   "differs. Said once a run.",
                   "G31 Z-10. F100"),
    ig::diagnostic(IG_ERROR, "ISO-0391", "G33 F{0}: a lead is greater than zero; the lead of before stays in force",
                   "F of G33 is the lead of the thread, in mm (or inches) per revolution.", "G33 Z-10. F0"),
    ig::diagnostic(IG_NOTE, "ISO-0392", "G60: the overrun of the axes is not known; a plain rapid is made",
                   "The control overruns the target by parameter 5440 and comes back to it, always from one side. The "
                   "end is the same.",
                   "G60 X10."),
    ig::diagnostic(IG_ERROR, "ISO-0393", "{0} {1}{2} is not executed",
                   "Known are G05.1 Q0 to Q3, G05 P0 and P10000, G08 P0 and P1. Other values call functions of the "
                   "machine: what they move is missing.",
                   "G05 P1"),
    ig::diagnostic(IG_WARNING, "ISO-0394", "{0} without {1}: nothing changes", "The word says on or off.", "G08"),
    ig::diagnostic(IG_WARNING, "ISO-0395", "G60 without an axis: nothing moves",
                   "G60 positions the axes that its block names.", "G60"),
    ig::diagnostic(
        IG_WARNING, "ISO-0396", "G97 without S after G96: no spindle speed is known",
        "The control keeps the revolutions that it reached under G96, which are not computed here. Program S "
        "with G97.",
        "G96 S200 (then) G97"),
    ig::diagnostic(IG_WARNING, "ISO-0397", "{0}: {1}{2} names an axis; nothing moves",
                   "Beside G05.1 an axis word says which axes are smoothed, and its value is 0. A move stands in a "
                   "block of its own.",
                   "G05.1 Q1 X10."),
    ig::diagnostic(IG_WARNING, "ISO-0398", "M29 was no rigid tapping: {0}, and no tapping cycle, comes after it",
                   "M29 without S may be a function of the machine (a chip conveyor). It is taken for one where the "
                   "next S, spindle code or axis move is not a tapping cycle. Said once a run.",
                   "M29 (then) G01 X10."),
    ig::diagnostic(
        IG_WARNING, "ISO-0399", "what stands behind ; is taken for a remark: the control ends the block there",
        "In files for this control ; shows where a block ends, and what follows is the next block. Plain text "
        "is none, and the control would stop with an alarm. Write remarks in parentheses. Said once a run.",
        "N1 G21 ; mm mode"),
    ig::diagnostic(
        IG_WARNING, "ISO-0511", "G04 without a time: F of this block is the feed, no time passes",
        "The time of G04 stands in X, U or P here; other controls read it from F. G04 alone is an exact stop.",
        "G04 F2."),
    ig::diagnostic(
        IG_NOTE, "ISO-0512", "H{0} without G43 or G44: the number is kept, no tool length is in force",
        "The length of row H counts from the next G43 or G44 on. Until then the tool goes as deep as if it had "
        "no length.",
        "G00 Z50. H1"),
    ig::diagnostic(IG_WARNING, "ISO-0513", "an arc without a centre and without R: the tool goes straight",
                   "Parameter 3403 bit 5 of the control says whether that is an alarm. A radius may have been lost.",
                   "G02 X10. Y10."),
    ig::diagnostic(
        IG_WARNING, "ISO-0514", "{0}: the bottom lies {1} mm above R, so the tool is fed away from the part",
        "R and the bottom are positions along the tool axis, under G91 increments; the bottom lies deeper. A "
        "Z that was to be a move may stand in a block of a cycle that is still on.",
        "G81 X10. Y10. Z5. R2."),
};

consteval std::uint32_t diag(std::string_view code) { return index_of(diagnostics, code, 0); }

}  // namespace iso
