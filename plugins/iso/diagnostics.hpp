/// The plugin's table of diagnostics: code, severity, text, explanation, an example that provokes it. The reference
/// page and `isogloss explain CODE` come from it. Codes are never reused.
#pragma once

#include <array>
#include <string_view>

#include <isogloss/sdk.hpp>

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
    // modal state, tables, program flow, inspection: 200–299
    ig::diagnostic(IG_WARNING, "ISO-0201", "more than one code of a modal group in this block: {0} counts",
                   "Codes of one group exclude each other. The control lets the last one count without an alarm; so "
                   "does this run. Remove the others.",
                   "G90 G91 X10."),
    ig::diagnostic(IG_ERROR, "ISO-0210", "F{0}: a feed is greater than zero; the feed of before stays in force",
                   "A control stops at the next feed move with F0 or a negative F. Nothing is written for it here.",
                   "G01 X10. F0"),
    ig::diagnostic(IG_WARNING, "ISO-0211", "{0} without F: the feed in force was given in {1}; none is in force now",
                   "F200 is 200 mm/min under G94 and 200 mm/rev under G95. Where the dialect says "
                   "mode-change=\"require-f\", changing the mode ends the old feed: program F in this block.",
                   "G95"),
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
                   "The control jumps to the start of the program and runs it again, until someone stops it.", "M99"),
    ig::diagnostic(IG_ERROR, "ISO-0260", "{0} is not executed: the tool runs on the programmed path",
                   "Cutter radius compensation is recognised only. Every path up to G40 is off by the tool radius.",
                   "G41 D1"),
    ig::diagnostic(IG_ERROR, "ISO-0261", "G16 is not executed: X and Y are taken as lengths, not as radius and angle",
                   "Polar command is recognised only. Every position up to G15 is unreliable.", "G16"),
    ig::diagnostic(IG_ERROR, "ISO-0262", "{0} is not executed: the path is neither scaled nor mirrored",
                   "Scaling (G51) and mirror image (G51.1) are recognised only. Positions up to G50 or G50.1 are "
                   "unreliable.",
                   "G51 X0 Y0 P500"),
    ig::diagnostic(IG_ERROR, "ISO-0263", "{0} is not executed: the frame is not rotated",
                   "Coordinate rotation (G68) and tilted planes (G68.2 to G68.4) are recognised only. Positions up to "
                   "G69 are unreliable.",
                   "G68 X0 Y0 R30."),
    ig::diagnostic(IG_ERROR, "ISO-0264", "{0} is not executed: the rotary axes stay where they are",
                   "Positioning of the rotary axes to the tilted plane is recognised only.", "G53.1"),
    ig::diagnostic(IG_ERROR, "ISO-0265", "{0} is not executed: the tool length of before stays in force",
                   "G43.1 and tool centre point control (G43.4, G43.5) are recognised only. Positions are unreliable "
                   "up to G49.",
                   "G43.4 H1"),
    ig::diagnostic(IG_ERROR, "ISO-0266", "{0} is not executed: the work coordinate systems stay as they are",
                   "Setting the coordinate system by the position of the tool is recognised only. Positions from here "
                   "on are unreliable.",
                   "G92 X0 Y0"),
    ig::diagnostic(IG_ERROR, "ISO-0267", "{0} is not executed: its move is left out",
                   "The tool stays where it is. The position is unreliable until every axis is programmed in G90.",
                   "G30 P2 Z0"),
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
    ig::diagnostic(IG_ERROR, "ISO-0271", "G96 is not executed: the spindle speed of before stays in force",
                   "Constant surface speed is recognised only. Spindle speed and feed per revolution are unreliable up "
                   "to G97.",
                   "G96 S200"),
    ig::diagnostic(IG_ERROR, "ISO-0272", "{0} is not executed: the forbidden zone is not watched",
                   "The stored stroke check is recognised only. Moves into the zone are not reported.",
                   "G22 X100. Y100. Z50. I0 J0 K0"),
    ig::diagnostic(IG_ERROR, "ISO-0280", "{0} is unknown here and not executed",
                   "No syntax of the dialect knows this G code. What it would move or change is missing: positions are "
                   "unreliable from here on.",
                   "G123"),
    ig::diagnostic(IG_WARNING, "ISO-0281", "{0} is unknown here and not executed",
                   "No syntax of the dialect knows this M code; most M codes are the machine builder's own.", "M123"),
    ig::diagnostic(IG_ERROR, "ISO-0282", "{0} is not executed in this block, nor are its words",
                   "The dialect knows the code, but no syntax answered it here. What it would move or change is "
                   "missing: positions are unreliable from here on.",
                   "G84 X10. Z-10. R2. F500"),
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
    ig::diagnostic(
        IG_WARNING, "ISO-0330", "G53 under G91 is ignored: nothing moves",
        "Machine coordinates are positions; the control ignores G53 while G91 is in force. Its axis words are "
        "not used.",
        "G91 G53 Z0"),
    ig::diagnostic(IG_NOTE, "ISO-0331", "G53 without an axis: nothing moves",
                   "G53 acts on the axis words of its block alone.", "G53"),
    ig::diagnostic(
        IG_ERROR, "ISO-0332", "the way from program to machine coordinates cannot be inverted",
        "A frame of this block flattens space: a scale of 0, or a tool axis of length 0. Positions from here "
        "on are unreliable.",
        "G51 X0 Y0 P0"),
    ig::diagnostic(IG_WARNING, "ISO-0340", "G28 without an axis: nothing moves",
                   "G28 returns the axes that its block names. Some controls stop with an alarm.", "G28"),
    ig::diagnostic(IG_WARNING, "ISO-0341",
                   "the machine's reference position of {0} is not known: machine zero is taken",
                   "Give the axis a Reference1 in the dialect's MachineAxes, or parameter 1240.", "G91 G28 Z0"),
};

/// The index of a code in the table; an unknown code does not compile.
consteval std::uint32_t diag(std::string_view code) {
  for (std::size_t i = 0; i < diagnostics.size(); ++i)
    if (code == diagnostics[i].code) return static_cast<std::uint32_t>(i);
  throw "no such diagnostic";
}

}  // namespace iso
