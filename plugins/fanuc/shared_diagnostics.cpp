// Diagnostics that several syntaxes of the plugin raise, or a header of theirs: they belong to no single page.
#include <isogloss/sdk.hpp>

namespace fanuc {
namespace {

const ig::Diagnostics shared_diagnostics{
    ig::diagnostic(IG_ERROR, "FAN-0101",
                   "'{0}' stands where a value is expected: write a number, a variable or brackets",
                   "An expression is made of numbers, variables (#1), brackets ([…]) and functions (SIN[…]), with an "
                   "operator between two values. The statement or word is not executed.",
                   "#1=2**3"),
    ig::diagnostic(IG_ERROR, "FAN-0102", "the bracket that opens here is never closed: write its ] in the same block",
                   "Each [ needs its ] in the same block. The statement or word is not executed.", "#1=[2+3"),
    ig::diagnostic(IG_ERROR, "FAN-0103",
                   "brackets are nested deeper than {0}: the expression is not computed; use several statements",
                   "A control permits 5 levels. Compute the value in several statements.", "#1=[[[… 65 brackets"),
    ig::diagnostic(IG_ERROR, "FAN-0104", "'{0}' is too large for a number: check it for repeated digits",
                   "The largest number is about 1.8e308. The statement or word is not executed.",
                   "#1=1 with 400 zeros after it"),
    ig::diagnostic(IG_ERROR, "FAN-0105", "'{0}' is not a function of this control: check its spelling",
                   "The functions are SIN COS TAN ASIN ACOS ATAN SQRT ABS BIN BCD ROUND FIX FUP LN EXP POW ADP; the "
                   "first two letters are enough. The statement or word is not executed.",
                   "#1=SINUS[30]"),
    ig::diagnostic(IG_ERROR, "FAN-0106", "'{0}' is a named variable, which this control does not have: write a number",
                   "Named variables belong to other controls. Write the number of the variable.", "#1=#<depth>"),
    ig::diagnostic(IG_ERROR, "FAN-0107",
                   "'{0}' has two # in a row: write #[#1] for the variable whose number stands in #1",
                   "On the control two # in a row are an alarm.", "#1=##2"),
    ig::diagnostic(IG_ERROR, "FAN-0108", "'{0}' is not a variable: its number must be whole and not negative",
                   "The number of a variable must not be empty either. Where the number is computed, check the "
                   "variables that it is computed from.",
                   "#[0-1]=2"),
    ig::diagnostic(IG_ERROR, "FAN-0109", "the control has no variable {0}: it is neither read nor written",
                   "Which common and permanent variables the control has is set by options of MacroVariables; so is "
                   "whether #2401 to #2800 are radii of tools (parameter 6004 bit 5).",
                   "#1=#40"),
    ig::diagnostic(IG_ERROR, "FAN-0110",
                   "the value of {0} is not known here: give it in a table of variables (--variables FILE)",
                   "Only the running machine knows this value, or nothing in the program has set it yet. The "
                   "statement or word is not executed.",
                   "#1=#5101"),
    ig::diagnostic(IG_ERROR, "FAN-0111", "division by zero: '{0}' is 0",
                   "The control stops with an alarm. Check the values that the divisor is computed from.",
                   "#1=1/[2-2]"),
    ig::diagnostic(IG_ERROR, "FAN-0112", "{0} has no value for this argument: check how the argument is computed",
                   "SQRT needs 0 or more, LN more than 0, ASIN and ACOS -1 to 1. TAN has no value at 90 degrees, ATAN "
                   "none for 0 and 0, POW none for a negative number with a fractional exponent.",
                   "#1=SQRT[-1]"),
    ig::diagnostic(IG_ERROR, "FAN-0113", "the result of '{0}' is too large for a number: check the variables in it",
                   "The largest number is about 1.8e308. The statement or word is not executed.", "#1=EXP[1000]"),
    ig::diagnostic(IG_ERROR, "FAN-0114",
                   "'{0}' is outside the range of its function: AND, OR and XOR need whole numbers of 32 bits, BCD "
                   "and BIN decimal digits",
                   "AND, OR and XOR work on whole numbers of 32 bits. BCD needs up to eight decimal digits; BIN needs "
                   "a number whose groups of four bits are each 0 to 9.",
                   "#1=BIN[26]"),
    ig::diagnostic(IG_ERROR, "FAN-0115",
                   "the comparison '{0}' is not a number: comparisons stand in the condition of IF and WHILE only",
                   "EQ NE GT GE LT LE belong in the condition of IF and WHILE, where AND, OR and XOR join them.",
                   "#1=[#2 EQ 3]"),
    ig::diagnostic(IG_ERROR, "FAN-0116",
                   "the condition '{0}' compares nothing: write EQ, NE, GT, GE, LT or LE between two values",
                   "A condition compares two values. Nothing is executed.", "IF[#1] GOTO 10"),
    ig::diagnostic(IG_WARNING, "FAN-0117", "brackets are nested {0} deep; the control permits {1}",
                   "The expression is computed here; on the control it is an alarm.", "#1=[[[[[[1]]]]]]"),
    ig::diagnostic(IG_WARNING, "FAN-0118",
                   "the state of #{0} is not known here: {1} is assumed; --variables FILE can give another",
                   "The variable is a signal, a switch or a counter of the machine. Give its value in a table of "
                   "variables (--variables FILE). The warning appears once for each variable.",
                   "IF[#1000 EQ 1] GOTO 10"),
    ig::diagnostic(IG_NOTE, "FAN-0141", "output: {0}",
                   "DPRNT and BPRNT write text to the output device of the control, POPEN and PCLOS open and close "
                   "the device, SETVN names variables on the screen. The run goes on.",
                   "DPRNT[X#1[43]]"),
    ig::diagnostic(IG_ERROR, "FAN-0142", "{0} has a mistake at '{1}': nothing is output",
                   "The brackets hold text and variables with their digits: #1[43] prints four digits before and "
                   "three after the decimal point.",
                   "DPRNT[#1[4"),
    ig::diagnostic(IG_ERROR, "FAN-0165", "program {0} is not found, so it is not called: {1}",
                   "The macro program is searched for in the file, beside it and in the folders given with "
                   "--subprograms.",
                   "G65 P9999"),
    ig::diagnostic(IG_WARNING, "FAN-0166",
                   "the argument {0}{1} has no decimal point: it is passed as {2}; write the point",
                   "The control is set to count an argument without a decimal point in least input increments of its "
                   "address.",
                   "G65 P9010 A5"),
    ig::diagnostic(IG_WARNING, "FAN-0168", "macro calls are nested {0} deep; the control permits {1}",
                   "The call is made here; on the control it is an alarm.", "G65 P9010 (in O9010)"),
    ig::diagnostic(IG_ERROR, "FAN-0170",
                   "this block asks for more than one jump or call: {0} is not called; give it its own block",
                   "A macro call stands in a block without M98, M99, macro statement or another call.",
                   "G65 P9010 M99"),
    ig::diagnostic(IG_ERROR, "FAN-0201", "{0} is not executed: {1}",
                   "The control has this function; this dialect only recognises it. The words of the function are "
                   "removed with it, so that they do not act as a move.",
                   "G13 I5. D1 F200"),
    ig::diagnostic(IG_WARNING, "FAN-0230", "'{0}' is no word with a number, so this block of the file is left out",
                   "A file that a control puts out holds letters with numbers. Statements, jumps and expressions of a "
                   "program are not executed when it is imported.",
                   "G10L2P1X#100"),
    ig::diagnostic(IG_WARNING, "FAN-0239", "'{0}' is too large for a work offset, so this value of {1} is left out",
                   "The table of work offsets holds up to 1e9 mm and degrees. The file may be damaged at this place.",
                   "G10L2P1B99999999999."),
    ig::diagnostic(IG_WARNING, "FAN-0241",
                   "the file does not tell its unit, so its lengths are read as mm: give the option unit",
                   "A Fanuc writes offsets in the unit of its input, and lengths of parameters in that of parameters "
                   "0000 and 1001. In a machine, write <Backup src=\"TOOLOFST.TXT\" unit=\"mm\"/>, or \"inch\".",
                   "G10L2P1X-12.5, from a control in inches"),
    ig::diagnostic(IG_WARNING, "FAN-0270",
                   "#{0} is an output of the machine: nothing is switched, and the program reads the value back",
                   "The run has no machine. Reported once for each output.", "#1100=1"),
    ig::diagnostic(IG_WARNING, "FAN-0271",
                   "#{0} is an input of the machine, which a control does not write: the program reads the value back",
                   "The control stops with an alarm. A table of variables gives inputs their states (MacroVariables). "
                   "Reported once for each input.",
                   "#1000=1"),
};

}  // namespace
}  // namespace fanuc
