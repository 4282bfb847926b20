/// Diagnostics of the controls that descend from Fanuc's. The part of the plugin's table that follows
/// macro_diagnostics.hpp.
#pragma once

#include "macro_diagnostics.hpp"

namespace fanuc {

inline constexpr std::array brand_diagnostics{
    ig::diagnostic(IG_ERROR, "FAN-0201", "{0} is not executed: {1}",
                   "The control has this function, but it is recognised here only. The words that belong to it go with "
                   "it, so that they are not taken for a move.",
                   "G13 I5. D1 F200"),
    ig::diagnostic(
        IG_WARNING, "FAN-0202", "D{0} of a canned cycle has no effect: the feed does not change on the way",
        "On a Mazak D is the distance at which the feed of a cycle changes. The hole is drilled at one feed.",
        "G81 X10. Z-20. R2. D3. F100"),
    ig::diagnostic(
        IG_ERROR, "FAN-0203", "M53 is not executed: the cycle returns to {0}, where it began",
        "On an Okuma a cycle with M53 returns to the level of G71. That is done where the tool stands at this "
        "level when the cycle begins; here it stands elsewhere, or no G71 came before.",
        "G71 Z100 (then, at Z50) G81 X10 Z-20 R5 F200 M53"),
    ig::diagnostic(IG_WARNING, "FAN-0204", "{0} without an axis: nothing is mirrored",
                   "G101 mirrors the axes that its block names, each at the work zero; the value of the word does not "
                   "count.",
                   "G101"),
};

consteval std::uint32_t brand_diag(std::string_view code) {
  return iso::index_of(brand_diagnostics, code, macro_diagnostics.size());
}

}  // namespace fanuc
