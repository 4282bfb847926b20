/// Blocks that restore a state, from the rows of the dialect's ProgramText.
#pragma once

#include "isogloss/engine/program_text.hpp"
#include "state/restart_values.hpp"

namespace isogloss::cli {

/// True when the dialect says how it writes a state.
bool has_preamble(const ProgramText& text);
/// One block a line. `layout` tells which values are lengths, which are written in the unit of the program.
std::string make_preamble(const ProgramText& text, const ProgramPoint& point, const ProgramLines& lines,
                          const Layout& layout);

}  // namespace isogloss::cli
