// Diagnostics that the readers of archives and of definition files share.
#include <isogloss/sdk.hpp>

namespace siemens {
namespace {

const ig::Diagnostics archive_diagnostics{
    ig::diagnostic(IG_WARNING, "SIE-0340",
                   "'{0}' is neither an assignment nor a definition that is read, so it is left out",
                   "Data files consist of lines such as R1=5, $TC_DP3[4,1]=104.38 and DEF CHAN REAL LENGTH.", "G0 X10"),
    ig::diagnostic(IG_WARNING, "SIE-0341",
                   "'{0}' is not executed: conditions and calls are left out, with the lines between IF and ENDIF",
                   "A file of data is read from top to bottom; nothing in it is run. The lines inside IF and loops are "
                   "left out as well.",
                   "IF ISFILE(\"/_N_DEF_DIR/_N_UGUD_DEF\")"),
    ig::diagnostic(
        IG_WARNING, "SIE-0342", "{0} has the value '{1}', which is not a number that is read: it is left out",
        "Expressions, and numbers beyond those of the control, are not read. Give the value in a table.", "R1=R2*3"),
    ig::diagnostic(IG_WARNING, "SIE-0349",
                   "the values of {0} do not fit the array, or its size is not known: those beyond are left out",
                   "A list of values needs the definition of its array in the same file, unless the array has one "
                   "dimension.",
                   "LIMITS[0,0]=SET(1,2,3)"),
    ig::diagnostic(IG_WARNING, "SIE-0350",
                   "{1} elements of the array {0} have values, too many for a table: these values are left out",
                   "Arrays of up to 10000 elements are read, and 200000 elements of a file.",
                   "DEF NCK REAL POINTS[200,200]=REP(1,20000)"),
    ig::diagnostic(IG_WARNING, "SIE-0351", "{0} is defined twice, so only the first definition is read",
                   "The control reports an alarm when it loads such a file.", "DEF NCK INT A, A"),
    ig::diagnostic(IG_WARNING, "SIE-0352",
                   "'{0}' is not a definition that is read, so the rest of the line is left out",
                   "The form is DEF NCK REAL NAME=1, OTHER[2,3].", "DEF NCK LENGTH"),
    ig::diagnostic(IG_WARNING, "SIE-0354", "there is no R parameter {0}, so the line is left out: they go up to R32534",
                   "R parameters are numbered from R0.", "R99999=1"),
    ig::diagnostic(IG_WARNING, "SIE-0362", "{0} cannot hold '{1}', so this value is left out: its definition is {2}",
                   "The value has another type than the definition in this file, is longer than the STRING, or is "
                   "outside the limits LLI and ULI.",
                   "DEF NCK STRING[3] LABEL=\"LONG\""),
    ig::diagnostic(IG_WARNING, "SIE-0363", "the macro {0} is left out, because {1}",
                   "A macro is a name of the user and a text, which stands on the same line.", "DEFINE IF AS M24"),
};

}  // namespace
}  // namespace siemens
