/// Diagnostics of subprograms: the part of the plugin's table that follows tool_center_diagnostics.hpp.
#pragma once

#include "cycle_diagnostics.hpp"

namespace iso {

inline constexpr std::array subprogram_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0481", "{0} without P: no program is called",
                   "P is the number of the program that is called; M97 wants the sequence number of its first block.",
                   "M98 L2"),
    ig::diagnostic(IG_ERROR, "ISO-0482", "{0}: P{1} is no program number; nothing is called",
                   "A program number is a whole number from 1 to 99999999.", "M98 P-1"),
    ig::diagnostic(IG_ERROR, "ISO-0483", "{0}: L{1} is no count of calls; the program is called once",
                   "L is a whole number from 0 to 99999999.", "M98 P1000 L2.5"),
    ig::diagnostic(IG_WARNING, "ISO-0484", "{0} with the count 0: the program is not called",
                   "Controls differ on what no calls at all means. Remove the block, or the count.", "M98 P1000 L0"),
    ig::diagnostic(
        IG_ERROR, "ISO-0485", "program {0} is not found, so it is not called: {1}",
        "Positions and modal state are unreliable from here on. A called program is looked for in the file of "
        "its caller, in the other files of the run, beside the main program (as O1234, O1234.nc, 1234.nc and "
        "so on), and in the places that --subprograms names.",
        "M98 P7777"),
    ig::diagnostic(IG_ERROR, "ISO-0486", "calls are nested {0} deep already: the control stops here; {1} is not called",
                   "The option levels of SubprogramCallSyntax says how many levels the control has (alarm PS0077 on "
                   "Fanuc). A program that calls itself never returns.",
                   "M98 P1 (in O1)"),
    ig::diagnostic(IG_ERROR, "ISO-0487", "M99 P{0}: the calling program has no N{0}; the run goes on behind the call",
                   "P of M99 is a sequence number of the program that is returned to.", "M99 P999"),
    ig::diagnostic(IG_ERROR, "ISO-0488", "M99 P{0} is no sequence number; P is not used",
                   "A sequence number is a whole number, zero or greater.", "M99 P1.5"),
    ig::diagnostic(
        IG_WARNING, "ISO-0489", "M99 with L{0} has no meaning here; L is not used",
        "M99 L0 drops the repeats of the call that are left. Other counts, and an L in the main program, mean "
        "nothing.",
        "M99 L2"),
    ig::diagnostic(IG_WARNING, "ISO-0490",
                   "another program, {0}, begins before {1} returned: the run returns to its caller",
                   "A called program ends with M99. A control stops with an alarm where that is missing.",
                   "O1001 (before the M99 of O1000)"),
    ig::diagnostic(IG_WARNING, "ISO-0491", "{0}: there is no O{1} for P{2}; O{2} is called once",
                   "Where P has more digits than a program number, the control takes the leading ones as a count. A "
                   "program of the whole number is there, one of the last digits is not: so the whole number counts.",
                   "M98 P51234 (with O51234 in the file)"),
    ig::diagnostic(IG_ERROR, "ISO-0492", "'{0}' stands behind no call: it is not used",
                   "The name of a program in angle brackets belongs to a call (M98 <PART>), or begins a program.",
                   "G00 X10. <PART>"),
    ig::diagnostic(IG_ERROR, "ISO-0493", "this block asks for more than one jump or call: {0} is not executed",
                   "The control wants M98, M99 and M198 alone in their block.", "M98 P1000 M99"),
    ig::diagnostic(IG_ERROR, "ISO-0494", "M99 P{0}: the program has no N{0}; the run ends here",
                   "In the main program M99 P jumps to a sequence number of it; on some controls in a subprogram, too.",
                   "M99 P999"),
    ig::diagnostic(IG_WARNING, "ISO-0495", "the main program ends here without M30, M02 or M99",
                   "The run ends. A control that comes to the mark at the end of the tape stops with an alarm (Fanuc: "
                   "END OF RECORD), and what M30 resets stays as it is.",
                   "% (with no M30 before it)"),
};

inline constexpr std::size_t subprogram_end = cycle_end + subprogram_diagnostics.size();

consteval std::uint32_t subprogram_diag(std::string_view code) {
  return index_of(subprogram_diagnostics, code, cycle_end);
}

}  // namespace iso
