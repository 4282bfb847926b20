/// Diagnostics of the Syntec plugin. The reference page and `isogloss explain CODE` come from this table. Codes are
/// never reused.
#pragma once

#include "diagnostic_index.hpp"

namespace syntec {

inline constexpr std::array diagnostics{
    ig::diagnostic(IG_ERROR, "SYN-0001", "the file is in MACRO format: it is not executed, from here to its end",
                   "A Syntec takes a file whose first line is %@MACRO for a program in its own macro language, with "
                   "statements, expressions and loops. That language is not read here: what the file moves and sets is "
                   "missing, and positions after a call of it are not reliable.",
                   "%@MACRO"),
    ig::diagnostic(
        IG_ERROR, "SYN-0002", "{0} calls the macro {1}, which is not executed: what it moves is missing",
        "G200 to G999 are macros of the machine's builder, and parameters (Pr3601 to Pr3610, Pr3701 to "
        "Pr3710, Pr3215) make M, G and T codes call one. Such a file is in MACRO format and is not read. The "
        "words of the block are its arguments and move nothing.",
        "G200 X10. Y5."),
    ig::diagnostic(IG_ERROR, "SYN-0003", "{0} is not executed: {1}",
                   "The control has this function, but it is recognised here only. The words that belong to it go with "
                   "it, so that they are not taken for a move.",
                   "G134 X0. Y0. I20. J0. K6"),
    ig::diagnostic(IG_ERROR, "SYN-0004", "${0}: the programs of further axis groups are not read, from here to the end",
                   "$1, $2 and so on begin the program of an axis group. They run at the same time; here that of the "
                   "first group is executed alone.",
                   "$2 G00 X10."),
    ig::diagnostic(IG_WARNING, "SYN-0005", "S{0} is more than {1} rpm, which Pr3741 allows",
                   "The spindle does not turn so fast; what the control does then (turn at the limit, or stop with an "
                   "alarm) is the machine builder's choice. The speed is recorded as programmed.",
                   "M03 S20000 (with Pr3741 = 12000)"),
    ig::diagnostic(IG_WARNING, "SYN-0006", "{0}: E{1} is no tolerance; the one in force stays",
                   "E of high-speed, high-precision control is how far the path may round a corner off: more than 0.",
                   "G05 P10000 E0"),
};

consteval std::uint32_t diag(std::string_view code) { return iso::index_of(diagnostics, code, 0); }

}  // namespace syntec
