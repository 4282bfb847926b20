// Diagnostics that several syntaxes of the plugin raise, or a header that they share: they belong to no page.
#include <isogloss/sdk.hpp>

namespace fanuc {
namespace {

const ig::Diagnostics shared_diagnostics{
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
    ig::diagnostic(IG_NOTE, "FAN-0141", "output: {0}",
                   "DPRNT and BPRNT write text to the output device of the control, POPEN and PCLOS open and close it; "
                   "SETVN names variables for the screen. The run goes on.",
                   "DPRNT[X#1[43]]"),
    ig::diagnostic(IG_ERROR, "FAN-0142", "{0} is written wrong at '{1}': nothing is put out",
                   "Between the brackets stand text and variables with their digits: #1[43] has four digits before and "
                   "three behind the point.",
                   "DPRNT[#1[4"),
    ig::diagnostic(IG_ERROR, "FAN-0165", "program {0} is not found, so it is not called: {1}",
                   "The macro program is looked for in the file, beside it and in the folders given with "
                   "--subprograms.",
                   "G65 P9999"),
    ig::diagnostic(IG_WARNING, "FAN-0166", "the argument {0}{1} has no decimal point: passed as {2}",
                   "An argument without a point counts increments of its address, as the control is set. Write the "
                   "point.",
                   "G65 P9010 A5"),
    ig::diagnostic(IG_WARNING, "FAN-0168", "macro calls are nested {0} deep; the control permits {1}",
                   "The call is made here; on the control it is an alarm.", "G65 P9010 (in O9010)"),
    ig::diagnostic(IG_ERROR, "FAN-0170", "this block asks for more than one jump or call: {0} is not called",
                   "A macro call stands in a block without M98, M99 or a macro statement.", "G65 P9010 M99"),
    ig::diagnostic(IG_ERROR, "FAN-0201", "{0} is not executed: {1}",
                   "The control has this function, but it is recognised here only. The words that belong to it go with "
                   "it, so that they are not taken for a move.",
                   "G13 I5. D1 F200"),
};

}  // namespace
}  // namespace fanuc
