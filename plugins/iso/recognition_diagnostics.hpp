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
};

inline constexpr std::size_t recognition_end = corner_end + recognition_diagnostics.size();

consteval std::uint32_t recognition_diag(std::string_view code) {
  return index_of(recognition_diagnostics, code, corner_end);
}

}  // namespace iso
