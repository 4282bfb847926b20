// Diagnostics that several syntaxes of the plugin raise, or a header that they share: they belong to no page.
#include <isogloss/sdk.hpp>

namespace siemens {
namespace {

const ig::Diagnostics shared_diagnostics{
    ig::diagnostic(IG_ERROR, "SIE-0101", "a value should stand here, not '{0}'",
                   "An expression is made of numbers, texts, variables, brackets and functions, with an operator "
                   "between two values.",
                   "R1=2*/3"),
    ig::diagnostic(IG_ERROR, "SIE-0102", "what opens here is not closed",
                   "Each ( has its ), each [ its ], each text its second quotation mark, in the same block.",
                   "R1=(2+3"),
    ig::diagnostic(IG_ERROR, "SIE-0103", "brackets are nested deeper than {0}: the expression is not computed",
                   "Compute in several steps.", "R1=((((… 50 brackets"),
    ig::diagnostic(IG_ERROR, "SIE-0104", "{0} is none of the variables",
                   "R parameters are numbered from R0 to what machine data say (r-parameters of SiemensVariables).",
                   "R99999=1"),
    ig::diagnostic(IG_ERROR, "SIE-0105", "{0}: the result is larger than any number that the control holds",
                   "Look for a typing error.", "R1=EXP(1000)"),
    ig::diagnostic(IG_ERROR, "SIE-0106", "{0} has no value",
                   "A root of a negative number, ASIN and ACOS beyond 1, TAN(90), bits of what is no "
                   "whole number.",
                   "R1=SQRT(-1)"),
    ig::diagnostic(IG_ERROR, "SIE-0107", "{0} mixes text and number",
                   "A text does not count, and a number is joined to a text by << only.", "R1=\"A\"+1"),
    ig::diagnostic(IG_WARNING, "SIE-0108", "'{0}' compares what was compared before: put brackets",
                   "The control computes comparisons last, after AND and OR: R1==1 AND R2==2 is R1==(1 AND R2)==2. It "
                   "is computed so here, too.",
                   "IF R1==1 AND R2==2 GOTOF L10"),
    ig::diagnostic(IG_ERROR, "SIE-0109", "the function {0} is not known here",
                   "Known are SIN COS TAN ASIN ACOS ATAN2 SQRT ABS POT TRUNC ROUND ROUNDUP LN EXP MINVAL MAXVAL BOUND "
                   "STRLEN NUMBER TOUPPER TOLOWER. What needs the value is not executed.",
                   "R1=SIGN(1)"),
    ig::diagnostic(
        IG_ERROR, "SIE-0110", "the value of {0} is not known here",
        "The variable belongs to the running machine. Give it a value in a table of variables (--variables FILE).",
        "R1=$AC_TIME"),
    ig::diagnostic(
        IG_ERROR, "SIE-0111", "no variable, array or function is called {0}",
        "The program does not define it: it may be a user variable of the machine (GUD). What needs its value "
        "is not executed. Give it one in a table of variables (--variables FILE). Said once for each.",
        "X=PART_LENGTH"),
    ig::diagnostic(IG_WARNING, "SIE-0112", "{0} was given no value: read as 0",
                   "R parameters keep their values between programs. Give it one in a table of variables (--variables "
                   "FILE). Said once for each.",
                   "X=R55"),
    ig::diagnostic(IG_ERROR, "SIE-0113", "{0} takes {1} values in its brackets",
                   "Look for a comma that is missing or too many.", "R1=ATAN2(1)"),
    ig::diagnostic(IG_ERROR, "SIE-0114", "{0}: the program has more variables than are kept",
                   "At most 100000, elements of arrays counted.", "DEF REAL A (a hundred thousand times)"),
    ig::diagnostic(IG_ERROR, "SIE-0124", "no variable or array is called {0}: nothing is assigned",
                   "The program does not define it: it may be a user variable of the machine (GUD). Give it a value in "
                   "a table of variables (--variables FILE). Said once for each.",
                   "PART_LENGTH=5"),
    ig::diagnostic(IG_WARNING, "SIE-0126", "'{0}' is for another spindle, or an auxiliary function: it is not executed",
                   "The run knows one spindle, the master spindle (master-spindle of SiemensWordSyntax).",
                   "M2=3 S2=500"),
    ig::diagnostic(
        IG_ERROR, "SIE-0129", "{0} is written, which is not executed here",
        "System variables change offsets, tools and machine data. What depends on them is unreliable from here on.",
        "$P_UIFR[1,X,TR]=10"),
    ig::diagnostic(IG_ERROR, "SIE-0130", "{0} cannot hold this value: nothing is assigned",
                   "A text goes into a STRING, a number into the other types.", "R1=\"A\""),
    ig::diagnostic(IG_ERROR, "SIE-0141", "'{0}' should not stand here: the statement is not executed",
                   "Nothing stands behind the statement but a comment.", "ENDIF X10"),
    ig::diagnostic(IG_ERROR, "SIE-0144", "the statement is not complete",
                   "The forms are FOR i=1 TO 10 and CASE (x) OF 1 GOTOF A DEFAULT GOTOF B.", "FOR R1=1"),
    ig::diagnostic(IG_ERROR, "SIE-0148", "'{0}' is no label",
                   "A label is a name, a sequence number, or a text that holds one.", "GOTOF 5"),
    ig::diagnostic(IG_ERROR, "SIE-0149", "the label {0} is not found: {1}",
                   "The control stops with an alarm. Here the run goes on in the next block.", "GOTOF NOWHERE"),
    ig::diagnostic(IG_ERROR, "SIE-0165", "{0} is not found, so it is not called: {1}",
                   "A subprogram is looked for in the file, beside it and in the folders given with --subprograms. "
                   "Cycles of the machine builder are there, too.",
                   "L999"),
    ig::diagnostic(IG_ERROR, "SIE-0167", "this block asks for more than one jump or call: {0} is not called",
                   "A call stands in a block of its own.", "L10 L20"),
    ig::diagnostic(IG_ERROR, "SIE-0183", "{0} is not executed: machine coordinates are wrong up to TRAFOOF",
                   "TRAORI is said once. It needs a machine that says where its rotary axes sit (--machine FILE). "
                   "TRANSMIT, TRACYL, TRAANG "
                   "and TRACON are not computed in this dialect.",
                   "TRANSMIT"),
    ig::diagnostic(IG_ERROR, "SIE-0185", "{0} without {1}: it is not executed", "The control stops with an alarm.",
                   "CYCLE81(50,0,2)"),
    ig::diagnostic(IG_ERROR, "SIE-0186", "{0}: no feed is in force",
                   "F stands before the cycle, with S under G95. G93 is not possible in a cycle.",
                   "CYCLE81(50,0,2,-20) (without F)"),
    ig::diagnostic(IG_ERROR, "SIE-0187", "{0}: a dwell of {1} turns, but the speed of the spindle is not known",
                   "A negative dwell counts turns of the spindle.", "CYCLE82(50,0,2,-20,,-3) (without S)"),
    ig::diagnostic(IG_NOTE, "SIE-0188", "{0}: DP and DPR are both given; DPR counts", "The control shows a message.",
                   "CYCLE81(50,0,2,-20,25)"),
    ig::diagnostic(IG_ERROR, "SIE-0189", "{0}: retract plane {1} and reference plane {2} do not fit (alarm 61101)",
                   "The retract plane lies on the side to which the tool leaves the hole; with DPR it differs from the "
                   "reference plane.",
                   "CYCLE81(0,0,2,,20)"),
    ig::diagnostic(IG_WARNING, "SIE-0190", "{0} with geometrical mode {1}: the depth counts for the tip of the drill",
                   "Depths for the shank or a diameter need the angle of the tip.", "CYCLE81(50,0,2,-20,,0,1)"),
    ig::diagnostic(IG_ERROR, "SIE-0191", "{0}: variant {1} is not executed",
                   "Other drilling axes (AXN) and variants of the newer cycles are not known here.",
                   "CYCLE83(50,0,2,-40,,-15,,0,0,0,1,0,1)"),
    ig::diagnostic(IG_ERROR, "SIE-0192", "{0}: the arc to the hole is shown as a straight line",
                   "A modal cycle drills at the end of the arc.", "MCALL CYCLE81(50,0,2,-20) (then) G2 X10 Y0 CR=5"),
    ig::diagnostic(IG_ERROR, "SIE-0195", "{0} takes more than {1} strokes: it is not executed",
                   "Look at the first depth and the degression.", "CYCLE83(50,0,2,-20,,-0.0001)"),
    ig::diagnostic(IG_ERROR, "SIE-0197", "{0}: {1}={2} is no direction of the spindle (alarm 61102): not executed",
                   "3 is clockwise, 4 counter-clockwise, 5 (SDAC only) stop. Without it the spindle turns already.",
                   "CYCLE86(50,0,2,-20,,0,7)"),
    ig::diagnostic(IG_ERROR, "SIE-0212", "the frame cannot be turned back: the program position is not known",
                   "Scales or mirrors make positions fall together.", "SUPA X0"),
    ig::diagnostic(IG_ERROR, "SIE-0214", "{0}({1}): the angle of a modulo axis lies from 0 to below 360 (alarm 16830)",
                   "Here the position of the circle counts.", "G0 C=DC(400)"),
    ig::diagnostic(IG_ERROR, "SIE-0261", "{0} is not executed: {1}", "The function is known by name only.", "TRANSMIT"),
    ig::diagnostic(IG_ERROR, "SIE-0262", "{0}", "The word is known by name only.", "G1 X10 FZ=0.1"),
    ig::diagnostic(IG_ERROR, "SIE-0271", "{0} without a drilling cycle under MCALL: no hole is made",
                   "MCALL with a cycle or a subprogram stands before.", "HOLES1(0,0,0,0,10,5)"),
    ig::diagnostic(IG_ERROR, "SIE-0272", "{0}: {1} holes are not executed; at most {2} are",
                   "The number is whole and at least 1; a row has at most 999 holes, a grid 9999.",
                   "HOLES2(0,0,20,0,0,0)"),
    ig::diagnostic(IG_ERROR, "SIE-0273", "{0}: {1} not executed: no hole is made",
                   "Executed are rows, circles, full grids and lists of absolute positions.",
                   "CYCLE801(0,0,0,10,10,3,3,1)"),
    ig::diagnostic(IG_ERROR, "SIE-0288", "the text '{0}' that stands for this name (DEFINE) is not executed here",
                   "A name can stand for words, for a call and for a value. It does not stand for parts of them, for "
                   "branches and jumps, or for another such name.",
                   "DEFINE AWAY AS GOTOF END"),
    ig::diagnostic(
        IG_ERROR, "SIE-0300",
        "{0} shifts rotary axes, but TRAORI and CYCLE800 reckon with machine angles here: check the machine data",
        "The offset counts in the words of rotary axes. Whether a transformation or a swivelled plane takes it off "
        "again "
        "is machine data; here it does not, as with 0 there. Set the offset to 0 in the table where the machine does.",
        "TRAORI (with an offset of C in the row of G54)"),
    ig::diagnostic(IG_ERROR, "SIE-0303", "{0} has room for {1} values from there on: the others are not stored",
                   "Count the elements: DEF REAL A[3] has A[0] to A[2].", "DEF REAL A[2]=SET(1,2,3)"),
    ig::diagnostic(
        IG_ERROR, "SIE-0304", "{0} lies outside the array, which is defined as {1}: indices count from 0",
        "DEF REAL A[3] has A[0], A[1] and A[2]; an array of two dimensions takes two indices. Nothing is read "
        "or assigned.",
        "A[3]=1 (behind DEF REAL A[3])"),
    ig::diagnostic(IG_ERROR, "SIE-0307", "{0} divides by zero", "What needs the value is not executed.", "R1=5/0"),
    ig::diagnostic(IG_ERROR, "SIE-0321", "{0} asks the control: what it answers is not known here",
                   "The function reads the tools, the curves or the axes of the machine. What needs the value is not "
                   "executed. Assign the value that it has on the machine.",
                   "R1=GETT(\"DRILL\",1)"),
};

}  // namespace
}  // namespace siemens
