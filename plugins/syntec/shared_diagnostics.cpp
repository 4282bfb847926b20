// Diagnostics that several syntaxes of the plugin raise, or a header of theirs: they belong to no single page.
#include <isogloss/sdk.hpp>

namespace syntec {
namespace {

const ig::Diagnostics shared_diagnostics{
    ig::diagnostic(IG_ERROR, "SYN-0003", "{0} is not executed: {1}",
                   "The control has this function; this dialect only recognises it. The words of the function are "
                   "removed with it, so that they do not act as a move.",
                   "G134 X0. Y0. I20. J0. K6"),
    ig::diagnostic(IG_ERROR, "SYN-0021", "'{0}' does not belong here: the statement or word is not executed",
                   "The text is no part of an expression of the macro language. Brackets of a calculation are ( ); "
                   "[ ] stand only behind # and @. A comparison for equality is =.",
                   "#1 := [1 + 2] * 3;"),
    ig::diagnostic(IG_ERROR, "SYN-0022", "the bracket or quotation mark that begins '{0}' is not closed",
                   "Nothing of the statement, or of the word, is executed.", "#1 := (2 + 3;"),
    ig::diagnostic(IG_ERROR, "SYN-0023", "the expression is nested deeper than {0} levels: it is not evaluated",
                   "Divide the calculation into several statements.", "#1 := ((( … )));"),
    ig::diagnostic(
        IG_ERROR, "SYN-0024", "the value of {0} is not known here: give it one with a row of SyntecVariables",
        "A register of the PLC, or a system variable, has a value that only the machine knows. The statement "
        "or word is not executed; of an IF no branch is executed, and a loop is skipped.",
        "IF @119044 <> 1 THEN"),
    ig::diagnostic(IG_ERROR, "SYN-0025", "{0} is not a variable of this control",
                   "Variables are #1 to #31986 and @1 to @165535, without the ranges that the control does not have. "
                   "Names such as #TEMP do not exist.",
                   "@3000 := 1;"),
    ig::diagnostic(
        IG_ERROR, "SYN-0026", "'{0}' is not a function of the macro language",
        "The functions stand on the page of SyntecMacroStatementSyntax. ATAN2 has two arguments; there is no "
        "FIX, FUP or INT.",
        "#1 := FIX(2.5);"),
    ig::diagnostic(IG_ERROR, "SYN-0027", "the value of '{0}' is known to the machine alone: nothing is executed",
                   "The function reads signals, files, drives or parameters of the machine, or a random number. The "
                   "statement or word is not executed; of an IF no branch is executed, and a loop is skipped.",
                   "#1 := READDI(31);"),
    ig::diagnostic(IG_ERROR, "SYN-0028", "'{0}' divides by 0: the statement or word is not executed",
                   "Integers are divided as integers: 1/2 is 0.", "#1 := 5 / (1/2);"),
    ig::diagnostic(
        IG_ERROR, "SYN-0029", "'{0}' has no value: an argument is outside the range of the function",
        "SQRT needs 0 or more, LN more than 0, ASIN and ACOS -1 to 1, POW a base that is not negative; ATAN2 "
        "needs one argument other than 0; POP and STKTOP need a value of PUSH.",
        "#1 := SQRT(-1);"),
    ig::diagnostic(IG_ERROR, "SYN-0030", "'{0}' is not an integer, which {1} needs: the statement is not executed",
                   "A number with a decimal point, and what is calculated with one, is no integer, also where its "
                   "decimals are 0.",
                   "#1 := 10. MOD 3;"),
    ig::diagnostic(IG_ERROR, "SYN-0031", "'{0}' is a text, not a number: the statement or word is not executed",
                   "Texts are compared with = and <>, and STR2INT makes numbers of them.", "#1 := \"AB\" + 1;"),
    ig::diagnostic(IG_WARNING, "SYN-0032", "'{0}' is VACANT: in this calculation it counts as 0",
                   "No value was assigned, or the call has no such argument. VACANT equals #0 alone, and not 0.",
                   "#1 := #2 + 1;"),
    ig::diagnostic(
        IG_ERROR, "SYN-0033", "'{0}' is too large: the statement or word is not executed",
        "Integers have 32 bits, from -2147483648 to 2147483647; write a decimal point for larger numbers. A text has "
        "at most 4095 characters here.",
        "#1 := 100000 * 100000;"),
    ig::diagnostic(IG_ERROR, "SYN-0034",
                   "the value of parameter {0} is not known here: give it one with a row of SyntecParameterTable",
                   "PARAM, and #4001 to #5500, read parameters of the control. The statement or word is not executed.",
                   "#1 := PARAM(3204);"),
    ig::diagnostic(
        IG_ERROR, "SYN-0040", "{0} cannot be written by a program here: nothing is assigned",
        "#0 and @0 are VACANT for ever; parameters and most system variables belong to the control. Modes are "
        "set by their codes (G90 instead of #1004).",
        "#1004 := 91;"),
    ig::diagnostic(IG_ERROR, "SYN-0050", "'{0}' is not executed: this dialect has no such statement or word",
                   "Commands of robots (MOVL, USERCOR) and variables of apps (AR, MAR) belong to other machines.",
                   "MOVL X100. Y0. FL100.;"),
    ig::diagnostic(IG_WARNING, "SYN-0056", "{0} holds whole numbers: {1} becomes {2}",
                   "Registers of the PLC, and #1080 to #1099, are integers: what stands behind the point is cut off.",
                   "@410 := 2.5;"),
    ig::diagnostic(IG_ERROR, "SYN-0053", "the statement that begins in line {0} of {1} has no end: it is not executed",
                   "A statement ends with ;, or with THEN, DO or OF. The file ended before.", "#1 := 5"),
    ig::diagnostic(IG_ERROR, "SYN-0057",
                   "the comment that begins in line {0} of {1} is not closed: nothing behind it is executed",
                   "A comment over several lines begins with (* and ends with *).", "(* HOLES"),
    ig::diagnostic(IG_ERROR, "SYN-0072", "the program {0} is not found, so it is not called: {1}",
                   "The macro's moves are missing. Macros have files without an extension, beside the program or in a "
                   "folder given with --subprograms.",
                   "G65 P9010 A1."),
    ig::diagnostic(IG_ERROR, "SYN-0073", "{0} L{1} is not a number of calls: write a whole number from 0",
                   "L is how often the macro is called. No macro is called.", "G65 P9010 L1.5"),
    ig::diagnostic(IG_WARNING, "SYN-0074", "{0} has L0, so the macro is not called: leave L out for one call",
                   "L is how often the macro is called.", "G65 P9010 L0"),
};

}  // namespace
}  // namespace syntec
