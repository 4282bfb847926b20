// Diagnostics that several syntaxes of the plugin raise, or a header of theirs: they belong to no single page.
#include <isogloss/sdk.hpp>

namespace siemens {
namespace {

const ig::Diagnostics shared_diagnostics{
    ig::diagnostic(IG_ERROR, "SIE-0101", "a value is expected here, not '{0}': correct the expression",
                   "An expression consists of numbers, texts, variables, brackets and functions, with an operator "
                   "between two values.",
                   "R1=2*/3"),
    ig::diagnostic(
        IG_ERROR, "SIE-0102", "the bracket or quotation mark that opens here is not closed: close it in the same block",
        "Each ( needs its ), each [ its ] and each text its second quotation mark, in the same block.", "R1=(2+3"),
    ig::diagnostic(
        IG_ERROR, "SIE-0103",
        "brackets are nested deeper than {0} levels, so the expression is not computed: use several assignments",
        "Compute the value in several steps.", "R1=((((… 50 brackets"),
    ig::diagnostic(IG_ERROR, "SIE-0104",
                   "there is no variable {0}: use an R parameter or an index that the control has",
                   "R parameters are numbered from R0 up to the number that the machine data allow (option "
                   "r-parameters of SiemensVariables).",
                   "R99999=1"),
    ig::diagnostic(IG_ERROR, "SIE-0105",
                   "{0} gives a number larger than any that the control holds: look for a typing error",
                   "The usual cause is a digit too many, or a missing decimal point.", "R1=EXP(1000)"),
    ig::diagnostic(IG_ERROR, "SIE-0106", "{0} has no result for these values: check the values before this block",
                   "The cause is the root of a negative number, ASIN or ACOS of a value beyond 1, TAN(90), or a bit "
                   "operation on a number that is not whole.",
                   "R1=SQRT(-1)"),
    ig::diagnostic(IG_ERROR, "SIE-0107",
                   "{0} mixes text and number: convert the text with NUMBER, or join both with <<",
                   "A text cannot be used in arithmetic, and only << joins a number to a text.", "R1=\"A\"+1"),
    ig::diagnostic(IG_WARNING, "SIE-0108",
                   "'{0}' compares the result of another comparison: put brackets around each comparison",
                   "The control evaluates comparisons last, after AND and OR: R1==1 AND R2==2 means R1==(1 AND R2)==2. "
                   "The run evaluates the expression in the same way.",
                   "IF R1==1 AND R2==2 GOTOF L10"),
    ig::diagnostic(IG_ERROR, "SIE-0109", "the function {0} is not supported: what needs its value is not executed",
                   "Supported are SIN COS TAN ASIN ACOS ATAN2 SQRT ABS POT TRUNC ROUND ROUNDUP LN EXP MINVAL MAXVAL "
                   "BOUND STRLEN NUMBER TOUPPER TOLOWER.",
                   "R1=SIGN(1)"),
    ig::diagnostic(IG_ERROR, "SIE-0110",
                   "the value of {0} is not known here: give it in a table of variables (--variables FILE)",
                   "The variable belongs to the running machine. What needs its value is not executed.", "R1=$AC_TIME"),
    ig::diagnostic(
        IG_ERROR, "SIE-0111",
        "there is no variable, array or function {0}: give it a value in a table of variables (--variables FILE)",
        "The program does not define the name: it may be a user variable of the machine (GUD). What needs its value is "
        "not executed. Reported once for each name.",
        "X=PART_LENGTH"),
    ig::diagnostic(IG_WARNING, "SIE-0112",
                   "{0} has no value yet, so 0 is assumed: assign it, or give it in a table of variables",
                   "R parameters keep their values from one program to the next. A table of variables (--variables "
                   "FILE) gives the value. Reported once for each parameter.",
                   "X=R55"),
    ig::diagnostic(IG_ERROR, "SIE-0113",
                   "{0} takes {1} values in its brackets: look for a missing comma or one too many",
                   "The brackets hold the values of the function, with commas between them.", "R1=ATAN2(1)"),
    ig::diagnostic(
        IG_ERROR, "SIE-0114", "{0} is not stored: the program has more variables than the run keeps",
        "At most 100000 variables are kept, and each element of an array counts as one. A REP for more stores nothing.",
        "DEF REAL A (a hundred thousand times)"),
    ig::diagnostic(
        IG_ERROR, "SIE-0124",
        "there is no variable or array {0}, so nothing is assigned: define it, or give it in a table of variables",
        "The program does not define the name: it may be a user variable of the machine (GUD). Give it a value in a "
        "table of variables (--variables FILE). Reported once for each name.",
        "PART_LENGTH=5"),
    ig::diagnostic(
        IG_WARNING, "SIE-0126", "'{0}' is for another spindle, or is an auxiliary function: it is not executed",
        "The run knows one spindle, the master spindle (option master-spindle of SiemensWordSyntax).", "M2=3 S2=500"),
    ig::diagnostic(
        IG_ERROR, "SIE-0129",
        "the assignment to {0} is not executed: what depends on this system variable may be wrong from here on",
        "System variables change offsets, tools and machine data.", "$P_UIFR[1,X,TR]=10"),
    ig::diagnostic(IG_ERROR, "SIE-0130", "{0} cannot hold this value, so nothing is assigned: check its type",
                   "A STRING holds a text, every other type holds a number.", "R1=\"A\""),
    ig::diagnostic(IG_ERROR, "SIE-0141",
                   "unexpected '{0}': the statement is not executed; remove what does not belong to it",
                   "Only a comment may follow the statement.", "ENDIF X10"),
    ig::diagnostic(IG_ERROR, "SIE-0144", "the FOR or CASE statement is not complete: write all of its parts",
                   "The forms are FOR i=1 TO 10 and CASE (x) OF 1 GOTOF A DEFAULT GOTOF B.", "FOR R1=1"),
    ig::diagnostic(IG_ERROR, "SIE-0148", "'{0}' is not a label: name a label or a block number",
                   "The target of a jump is a name, a block number (N100), or a text that holds one of them.",
                   "GOTOF 5"),
    ig::diagnostic(IG_ERROR, "SIE-0149", "the label {0} is not found ({1}): the jump is not made",
                   "The control stops with an alarm. Here the run continues with the next block.", "GOTOF NOWHERE"),
    ig::diagnostic(IG_ERROR, "SIE-0165", "{0} is not found, so it is not called: {1}",
                   "A subprogram is searched for in the file, beside it and in the folders given with --subprograms. "
                   "Cycles of the machine builder belong there, too.",
                   "L999"),
    ig::diagnostic(IG_ERROR, "SIE-0167",
                   "{0} is not called, because the block asks for another jump or call: write {0} in its own block",
                   "A call stands in a block of its own.", "L10 L20"),
    ig::diagnostic(IG_ERROR, "SIE-0183", "{0} is not executed: machine coordinates are wrong up to TRAFOOF",
                   "TRAORI needs a machine whose description says where its rotary axes are (--machine FILE); it is "
                   "reported once. TRANSMIT, TRACYL, TRAANG and TRACON are not supported in this dialect.",
                   "TRANSMIT"),
    ig::diagnostic(IG_ERROR, "SIE-0185", "{0} is not executed, because {1} is missing: give the parameter a value",
                   "The control stops with an alarm.", "CYCLE81(50,0,2)"),
    ig::diagnostic(IG_ERROR, "SIE-0186", "{0} has no feed rate: program F before the cycle",
                   "F stands before the cycle; under G95 the cycle needs S, too. A cycle cannot use G93.",
                   "CYCLE81(50,0,2,-20) (without F)"),
    ig::diagnostic(IG_ERROR, "SIE-0187",
                   "{0} has a dwell of {1} turns, but the spindle speed is not known: program S before it",
                   "A negative dwell is a number of spindle turns.", "CYCLE82(50,0,2,-20,,-3) (without S)"),
    ig::diagnostic(IG_NOTE, "SIE-0188", "{0}: DP and DPR are both given, and DPR is used: remove one of them",
                   "The control shows a message.", "CYCLE81(50,0,2,-20,25)"),
    ig::diagnostic(IG_ERROR, "SIE-0189",
                   "{0} is not executed: retract plane {1} mm and reference plane {2} mm do not fit (alarm 61101)",
                   "The retract plane lies on the side to which the tool leaves the hole. With DPR it must differ from "
                   "the reference plane.",
                   "CYCLE81(0,0,2,,20)"),
    ig::diagnostic(
        IG_WARNING, "SIE-0190", "{0}: geometrical mode {1} is not supported, so the depth is that of the drill tip",
        "Depths for the shank or for a diameter need the point angle of the tool.", "CYCLE81(50,0,2,-20,,0,1)"),
    ig::diagnostic(IG_ERROR, "SIE-0191", "{0}: the variant with the value {1} in this parameter is not executed",
                   "Other drilling axes (AXN) and variants of newer cycle versions are not supported.",
                   "CYCLE83(50,0,2,-40,,-15,,0,0,0,1,0,1)"),
    ig::diagnostic(
        IG_ERROR, "SIE-0192", "{0}: the arc to the hole is shown as a straight line; position the hole with a line",
        "A modal cycle drills at the end point of the arc.", "MCALL CYCLE81(50,0,2,-20) (then) G2 X10 Y0 CR=5"),
    ig::diagnostic(IG_ERROR, "SIE-0195",
                   "{0} would take more than {1} strokes and is not executed: check first depth and degression",
                   "A very small infeed is the usual cause.", "CYCLE83(50,0,2,-20,,-0.0001)"),
    ig::diagnostic(IG_ERROR, "SIE-0197", "{0} is not executed: {1}={2} is not a spindle direction (alarm 61102)",
                   "3 is clockwise, 4 is counter-clockwise, 5 (SDAC only) is stop. Without the parameter the spindle "
                   "must already turn.",
                   "CYCLE86(50,0,2,-20,,0,7)"),
    ig::diagnostic(IG_ERROR, "SIE-0212",
                   "the program position is not known, because the frame has no inverse: check its scales and mirrors",
                   "Scales or mirrors give several positions the same place.", "SUPA X0"),
    ig::diagnostic(IG_ERROR, "SIE-0214",
                   "{0}({1}): the angle of a modulo axis is from 0 to below 360 degrees (alarm 16830)",
                   "The run uses the same position on the circle.", "G0 C=DC(400)"),
    ig::diagnostic(IG_ERROR, "SIE-0261", "{0} is not executed: {1}", "The function is recognised by its name only.",
                   "TRANSMIT"),
    ig::diagnostic(IG_ERROR, "SIE-0262", "{0}", "The word is recognised by its name only.", "G1 X10 FZ=0.1"),
    ig::diagnostic(IG_ERROR, "SIE-0271",
                   "{0} drills no hole, because no drilling cycle is modal: program MCALL with a cycle before it",
                   "MCALL with a cycle or a subprogram stands before the pattern.", "HOLES1(0,0,0,0,10,5)"),
    ig::diagnostic(IG_ERROR, "SIE-0272", "{0} with {1} holes is not executed: program a whole number from 1 to {2}",
                   "A row has at most 999 holes and a grid 9999.", "HOLES2(0,0,20,0,0,0)"),
    ig::diagnostic(IG_ERROR, "SIE-0273", "{0}: {1} not executed, so no hole is drilled",
                   "Rows, circles, full grids and lists of absolute positions are executed.",
                   "CYCLE801(0,0,0,10,10,3,3,1)"),
    ig::diagnostic(IG_ERROR, "SIE-0280", "{0} beside {1} is not executed: program it in a block of its own",
                   "A pattern of holes moves the tool itself, to each of its positions.", "HOLES1(0,0,0,0,10,5) X20"),
    ig::diagnostic(IG_ERROR, "SIE-0288",
                   "the text '{0}' that DEFINE gives this name is not executed here: write it out in the block",
                   "A name can stand for words, for a call or for a value. It cannot stand for a part of them, for a "
                   "branch or jump, or for another such name.",
                   "DEFINE AWAY AS GOTOF END"),
    ig::diagnostic(
        IG_ERROR, "SIE-0300",
        "{0} shifts rotary axes, but TRAORI and CYCLE800 calculate with machine angles here: check the machine data",
        "The offset applies to the words of rotary axes. Machine data decide whether a transformation or a swivelled "
        "plane takes it off again; here it is not taken off. If your machine takes it off, set the offset to 0 in the "
        "table.",
        "TRAORI (with an offset of C in the row of G54)"),
    ig::diagnostic(IG_ERROR, "SIE-0303",
                   "{0} has room for {1} values from there on: the others are not stored; check the size of the array",
                   "Count the elements: DEF REAL A[3] has A[0] to A[2].", "DEF REAL A[2]=SET(1,2,3)"),
    ig::diagnostic(IG_ERROR, "SIE-0304", "{0} lies outside the array, which is defined as {1}: indices count from 0",
                   "DEF REAL A[3] has A[0], A[1] and A[2]; an array of two dimensions takes two indices. Nothing is "
                   "read or assigned.",
                   "A[3]=1 (after DEF REAL A[3])"),
    ig::diagnostic(IG_ERROR, "SIE-0307",
                   "{0} divides by zero, so what needs the value is not executed: check the divisor",
                   "The divisor is 0 in this block.", "R1=5/0"),
    ig::diagnostic(
        IG_ERROR, "SIE-0308",
        "the call in line {0} passes more values than {1} has parameters ({2} for {3}): the others are ignored",
        "The values beyond the parameters of PROC have no effect; a program without PROC has no parameters. "
        "The control stops with an alarm. Reported once for each calling line.",
        "PART(1,2) (and PROC PART(REAL A))"),
    ig::diagnostic(IG_ERROR, "SIE-0321",
                   "{0} asks the control for a value that is not known here: assign the value in the program",
                   "The function reads the tools, curves or axes of the machine. What needs the value is not executed. "
                   "Assign the value that it has on the machine.",
                   "R1=GETT(\"DRILL\",1)"),
    ig::diagnostic(IG_ERROR, "SIE-0360",
                   "the value {1} is outside the range of {0}, which is {2}, so nothing is assigned: check the value",
                   "The range is that of the type (INT: 32 bits, CHAR: 0 to 255) or of the limits LLI and ULI in the "
                   "definition. The control stops with an alarm.",
                   "STOCK=7 (after DEF NCK REAL LLI 0 ULI 5 STOCK)"),
    ig::diagnostic(IG_ERROR, "SIE-0361",
                   "{0} has room for {2} characters, so '{1}' is not assigned: shorten the text, or define it longer",
                   "The definition gives the length: STRING[20]. The option long-text of SiemensVariables cuts such "
                   "texts.",
                   "DEF STRING[3] NAME=\"DRILL\""),
    ig::diagnostic(IG_WARNING, "SIE-0364",
                   "{0} is an output of the machine: nothing is switched, and programs read the value back",
                   "Reported once for each output. A row of the output in SiemensVariables makes the assignment "
                   "silent.",
                   "$A_OUT[3]=1"),
    ig::diagnostic(
        IG_ERROR, "SIE-0365",
        "'{0}' is not a frame that a FRAME variable can hold, so nothing is assigned: use CTRANS and CROT",
        "The links are CTRANS, CFINE, CROT, CSCALE and CMIRROR of X, Y and Z, with A, B and C in shifts, and "
        "other frames. A rotation cannot follow a mirror or different scales.",
        "PART=CTRANS(Q,10)"),
};

}  // namespace
}  // namespace siemens
