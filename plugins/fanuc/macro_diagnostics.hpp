/// Diagnostics of custom macro B. The reference page and `isogloss explain CODE` come from this table. Codes are never
/// reused.
#pragma once

#include "diagnostic_index.hpp"

namespace fanuc {

inline constexpr std::array macro_diagnostics{
    // expressions
    ig::diagnostic(IG_ERROR, "FAN-0101", "a value should stand here, not '{0}'",
                   "An expression is made of numbers, variables (#1), brackets ([…]) and functions (SIN[…]), with an "
                   "operator between two values. The statement or word is not executed.",
                   "#1=2**3"),
    ig::diagnostic(IG_ERROR, "FAN-0102", "the bracket that opens here is not closed",
                   "Each [ has its ] in the same block. The statement or word is not executed.", "#1=[2+3"),
    ig::diagnostic(IG_ERROR, "FAN-0103", "brackets are nested deeper than {0}: the expression is not computed",
                   "Controls permit 5. Compute in several steps.", "#1=[[[… 65 brackets"),
    ig::diagnostic(IG_ERROR, "FAN-0104", "'{0}' is larger than any number", "Look for a typing error.",
                   "#1=1 with 400 zeros after it"),
    ig::diagnostic(IG_ERROR, "FAN-0105", "'{0}' is no function of this control",
                   "The functions are SIN COS TAN ASIN ACOS ATAN SQRT ABS BIN BCD ROUND FIX FUP LN EXP POW ADP; the "
                   "first two letters will do.",
                   "#1=SINUS[30]"),
    ig::diagnostic(IG_ERROR, "FAN-0106", "'{0}': this control has no variables with names",
                   "Named variables belong to another control. Write the number of the variable.", "#1=#<depth>"),
    ig::diagnostic(IG_ERROR, "FAN-0107", "'{0}': write #[#1] for the variable whose number stands in #1",
                   "Two # in a row are an alarm on the control.", "#1=##2"),
    ig::diagnostic(IG_ERROR, "FAN-0108", "'{0}' names no variable",
                   "The number of a variable is whole, not negative and not empty. If it is computed, look at the "
                   "variables that it is computed from.",
                   "#[0-1]=2"),
    ig::diagnostic(IG_ERROR, "FAN-0109", "the control has no variable {0}",
                   "Nothing is read from or written to it. Which common and permanent variables there are is an "
                   "option of MacroVariables; so is whether #2401 to #2800 are radii of tools (parameter 6004 bit 5).",
                   "#1=#40"),
    ig::diagnostic(IG_ERROR, "FAN-0110", "the value of {0} is not known here",
                   "The variable belongs to the running machine. Give it a value in a table of variables "
                   "(--variables FILE).",
                   "#1=#5101"),
    ig::diagnostic(IG_ERROR, "FAN-0111", "division by zero: '{0}' is 0", "The control stops with an alarm.",
                   "#1=1/[2-2]"),
    ig::diagnostic(IG_ERROR, "FAN-0112", "{0} has no value for this argument",
                   "SQRT wants 0 or more, LN more than 0, ASIN and ACOS -1 to 1; TAN has none at 90 degrees, ATAN none "
                   "for 0 and 0, POW none for a broken power of a negative number.",
                   "#1=SQRT[-1]"),
    ig::diagnostic(IG_ERROR, "FAN-0113", "the result of '{0}' is too large", "No number holds it.", "#1=EXP[1000]"),
    ig::diagnostic(IG_ERROR, "FAN-0114", "'{0}' is no whole number of 32 bits",
                   "AND, OR and XOR work on whole numbers of 32 bits; BCD wants up to eight decimal digits, BIN digits "
                   "of four bits from 0 to 9.",
                   "#1=BIN[26]"),
    ig::diagnostic(IG_ERROR, "FAN-0115", "the comparison '{0}' is no number",
                   "EQ NE GT GE LT LE stand in the condition of IF and WHILE only, joined by AND, OR, XOR.",
                   "#1=[#2 EQ 3]"),
    ig::diagnostic(IG_ERROR, "FAN-0116", "the condition '{0}' compares nothing",
                   "A condition compares two values: EQ NE GT GE LT LE.", "IF[#1] GOTO 10"),
    ig::diagnostic(IG_WARNING, "FAN-0117", "brackets are nested {0} deep; the control permits {1}",
                   "The expression is computed here; on the control it is an alarm.", "#1=[[[[[[1]]]]]]"),
    ig::diagnostic(IG_WARNING, "FAN-0118", "the state of #{0} is not known here: read as {1}",
                   "It is a signal, a switch or a counter of the machine. Give it a value in a table of variables "
                   "(--variables FILE). Said once for each variable.",
                   "IF[#1000 EQ 1] GOTO 10"),
    // assignments
    ig::diagnostic(IG_ERROR, "FAN-0121", "{0} cannot be written",
                   "#0 is always empty, and the variables of positions and modal codes only tell. Nothing is assigned.",
                   "#5041=0"),
    ig::diagnostic(IG_ERROR, "FAN-0122", "the tables have no place for {0}: nothing is written",
                   "The offset that the variable stands for is not in the table of work offsets or tools.",
                   "#2200=1 (in a table of 99 tools)"),
    ig::diagnostic(IG_ERROR, "FAN-0123", "'{0}' should not stand here: the statement is not executed",
                   "A block holds one macro statement and nothing else. Look for a missing operator or bracket.",
                   "#1=2 3"),
    ig::diagnostic(IG_ERROR, "FAN-0124", "= is missing: nothing is assigned", "An assignment is #1=value.", "#1 5"),
    ig::diagnostic(IG_ERROR, "FAN-0125", "a macro statement behind words: '{0}' is not executed",
                   "A macro statement stands in a block of its own, behind N.", "G01 X5. #1=2"),
    // flow
    ig::diagnostic(
        IG_ERROR, "FAN-0131", "{0} is not complete: {1} is missing; nothing is executed",
        "The forms are IF[condition]GOTO n, IF[condition]THEN #1=value, WHILE[condition]DO m, END m, GOTO n.",
        "IF #1 EQ 2 GOTO 10"),
    ig::diagnostic(IG_ERROR, "FAN-0132", "GOTO {0}: no sequence number is called so",
                   "A sequence number is whole, from 1 to 99999999.", "GOTO [2.5]"),
    ig::diagnostic(IG_ERROR, "FAN-0133", "N{0} is not found: {1}", "The control stops with an alarm.", "GOTO 9999"),
    ig::diagnostic(IG_ERROR, "FAN-0134", "{0}{1}: loops are numbered from 1 to {2}",
                   "DO and END take the numbers 1, 2 and 3.", "DO4"),
    ig::diagnostic(IG_ERROR, "FAN-0135", "END{0} of this loop is not found: {1}",
                   "A loop ends at the next END with its number. The run goes on behind the WHILE.",
                   "WHILE[1 EQ 2]DO1 (without END1)"),
    ig::diagnostic(IG_ERROR, "FAN-0136", "END{0} without DO{0}",
                   "The loop was not begun: its WHILE is missing, or a GOTO jumped into it, which controls do not "
                   "permit. The run goes on behind the END.",
                   "END1"),
    ig::diagnostic(IG_ERROR, "FAN-0137", "END{0} crosses DO{1} of line {2}", "The loop that began last ends first.",
                   "DO1 (then) DO2 (then) END1"),
    ig::diagnostic(IG_ERROR, "FAN-0138", "DO{0} inside DO{0} of line {1}",
                   "A loop inside another one has another number.", "DO1 (then) DO1"),
    ig::diagnostic(IG_ERROR, "FAN-0139", "alarm {0}: {1}",
                   "The program itself stops the control, by #3000. It says why.", "#3000=1(NO TOOL)"),
    ig::diagnostic(IG_NOTE, "FAN-0140", "the program stops and says: {0}",
                   "#3006 shows a message and waits for the start button.", "#3006=1(TURN THE PART)"),
    ig::diagnostic(IG_NOTE, "FAN-0141", "output: {0}",
                   "DPRNT and BPRNT write text to the output device of the control, POPEN and PCLOS open and close it; "
                   "SETVN names variables for the screen. The run goes on.",
                   "DPRNT[X#1[43]]"),
    ig::diagnostic(IG_ERROR, "FAN-0142", "{0} is written wrong at '{1}': nothing is put out",
                   "Between the brackets stand text and variables with their digits: #1[43] has four digits before and "
                   "three behind the point.",
                   "DPRNT[#1[4"),
    ig::diagnostic(IG_WARNING, "FAN-0143", "THEN is followed by words, not by a macro statement",
                   "The control executes one macro statement behind THEN. Here the words are executed when the "
                   "condition holds.",
                   "IF[#1 EQ 0] THEN M01"),
    ig::diagnostic(IG_ERROR, "FAN-0144", "DO{0} without END{0}: the program ends before it",
                   "Each DO has its END behind it in the same program; the control stops with an alarm. The blocks "
                   "behind DO are run once.",
                   "WHILE[#1 LT 5]DO1 (then, without END1, the end of the program)"),
    // words
    ig::diagnostic(IG_ERROR, "FAN-0151", "'{0}': {1} takes no variable; it is not used",
                   "Sequence and program numbers are written as numbers.", "N#1 G00 X1."),
    ig::diagnostic(IG_ERROR, "FAN-0152", "{0}{1} is no code",
                   "Codes are whole numbers, or have one decimal (54.1), from 0 to 9999.", "G#1 (where #1 is -3)"),
    ig::diagnostic(IG_WARNING, "FAN-0153", "'{0}': a calculation in a word stands in brackets",
                   "The control takes one variable or one pair of brackets for a word. Here the calculation counts.",
                   "X#1+2"),
    ig::diagnostic(
        IG_WARNING, "FAN-0154", "'{0}': the address stands more than once in this block: the last one counts",
        "The control lets the last word of an address count without an alarm; so does this run.", "G01 X1. X#1 F100"),
    ig::diagnostic(IG_NOTE, "FAN-0155", "{0} is empty, so the block has no such word",
                   "The variable was given no value. A feed move needs F in its block or before it.",
                   "G01 X10. F#652 (where nothing was assigned to #652)"),
    // calls
    ig::diagnostic(IG_ERROR, "FAN-0161", "{0} without P: no macro is called", "P is the number of the macro program.",
                   "G65 A1. B2."),
    ig::diagnostic(IG_ERROR, "FAN-0162", "{0} P{1}: no program has that number",
                   "Program numbers are whole, from 1 to 99999999.", "G65 P0"),
    ig::diagnostic(
        IG_ERROR, "FAN-0163", "'{0}' is no argument of a macro call: it is not passed",
        "Arguments are A to F, H to K, M and Q to Z with a number. G, N and O are none; L and P say how often "
        "and what is called.",
        "G65 P9010 N5"),
    ig::diagnostic(IG_ERROR, "FAN-0164", "more than ten sets of I J K: '{0}' is not passed",
                   "The variables #4 to #33 take ten sets.", "G65 P9010 with I eleven times"),
    ig::diagnostic(IG_ERROR, "FAN-0165", "program {0} is not found, so it is not called: {1}",
                   "The macro program is looked for in the file, beside it and in the folders given with "
                   "--subprograms.",
                   "G65 P9999"),
    ig::diagnostic(IG_WARNING, "FAN-0166", "the argument {0}{1} has no decimal point: passed as {2}",
                   "An argument without a point counts increments of its address, as the control is set. Write the "
                   "point.",
                   "G65 P9010 A5"),
    ig::diagnostic(IG_ERROR, "FAN-0167", "{0} L{1}: a call is made from 0 to 99999999 times", "L is a whole number.",
                   "G65 P9010 L-1"),
    ig::diagnostic(IG_WARNING, "FAN-0168", "macro calls are nested {0} deep; the control permits {1}",
                   "The call is made here; on the control it is an alarm.", "G65 P9010 (in O9010)"),
    ig::diagnostic(IG_WARNING, "FAN-0169", "G67 without G66: nothing ends", "No macro is called after the blocks.",
                   "G67"),
    ig::diagnostic(IG_ERROR, "FAN-0170", "this block asks for more than one jump or call: {0} is not called",
                   "A macro call stands in a block without M98, M99 or a macro statement.", "G65 P9010 M99"),
    ig::diagnostic(IG_ERROR, "FAN-0171", "G66 with {0} modal calls in force: macro calls nest {1} deep; it is not kept",
                   "Each G66 that no G67 ended is one level of macro calls. The control stops with an alarm. The calls "
                   "before stay in force.",
                   "G66 P9010 (six times, without G67)"),
    ig::diagnostic(IG_WARNING, "FAN-0172", "{0} with the count 0: the macro is not called",
                   "L says how often; leave it out for one call.", "G65 P9010 L0"),
    ig::diagnostic(
        IG_WARNING, "FAN-0173", "the program waits for #{0}, whose state is not known here: the wait is left",
        "A WHILE or an IF with GOTO asks a signal of the machine over and over, and nothing else changes. The "
        "run goes on as if the machine had answered. Said once for each signal.",
        "WHILE[#1004EQ0]DO1 (then) END1"),
    ig::diagnostic(IG_WARNING, "FAN-0174", "{0} stands more than once in this call: the last one counts",
                   "Each letter is one argument, but for I, J and K, which may come in sets.", "G65 P9010 A1. A2."),
};

consteval std::uint32_t macro_diag(std::string_view code) { return iso::index_of(macro_diagnostics, code, 0); }

}  // namespace fanuc
