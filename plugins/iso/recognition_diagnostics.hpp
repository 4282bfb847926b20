/// Diagnostics of texts that are no program for this control: the part of the plugin's table that follows
/// corner_diagnostics.hpp.
#pragma once

#include "corner_diagnostics.hpp"

namespace iso {

inline constexpr std::array recognition_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0540",
                   "{0} in line {1} shows a turning program, and this dialect mills: nothing of the text is executed",
                   "A lathe takes X for a diameter, T0101 for a tool with its offset and G50 S for the highest spindle "
                   "speed; positions of a mill would be wrong throughout. Where the program mills all the same, "
                   "<Remove syntax=\"TurningProgramSyntax\"/> in a dialect of your own executes it.",
                   "T0101 (in a text without M06 and Y)"),
    ig::diagnostic(IG_ERROR, "ISO-0541",
                   "'{0}' is an O-word of LinuxCNC, which no dialect here executes: the run stops at this block",
                   "O-words begin subprograms, loops and branches. Without them the bodies of subprograms would run as "
                   "the main program, and each loop once.",
                   "o100 sub"),
    ig::diagnostic(
        IG_ERROR, "ISO-0542",
        "{0} is not supported here, so the words {1} of its block move nothing: check the code or the dialect",
        "A code that the dialect does not know may be a macro, a cycle or a tilted plane, whose words are no "
        "positions. Positions are unreliable from here on.",
        "G200 X10. A30."),
    ig::diagnostic(IG_ERROR, "ISO-0543",
                   "X of this block is a word of {0} and not a move: program the dwell in a block of its own",
                   "G04 takes the X of its block for a time, also where a motion code stands beside it.",
                   "G04 P100 G00 X1. Y1."),
    ig::diagnostic(IG_ERROR, "ISO-0544",
                   "{0} beside G10 L{1} is not executed: this table has no such value, so remove the word",
                   "L2 and L20 write positions of work offsets, L10 to L13 write R alone.", "G10 L10 P1 R5. Z3."),
    ig::diagnostic(IG_ERROR, "ISO-0545", "{0} moves nothing: no axis {1} is known here",
                   "A machine may have further linear axes U, V and W; here it has X, Y, Z and rotary axes.", "G1 W5."),
    ig::diagnostic(
        IG_NOTE, "ISO-0546",
        "words of this arc have no decimal point, so they count least increments; if the program means "
        "millimetres or inches, {0}",
        "The same program is a thousand times larger on a control that is set to read whole numbers as units. "
        "An arc that cannot close is often the first sign.",
        "G2 X10. Y0 I5 J0 (where I5 is 0.005 mm)"),
    ig::diagnostic(IG_WARNING, "ISO-0547", "{0} stands in this block already: the second one changes nothing",
                   "A typing error, most often: another code was meant.", "M08 M08"),
};

inline constexpr std::size_t recognition_end = corner_end + recognition_diagnostics.size();

consteval std::uint32_t recognition_diag(std::string_view code) {
  return index_of(recognition_diagnostics, code, corner_end);
}

}  // namespace iso
