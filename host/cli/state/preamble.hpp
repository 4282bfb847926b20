/// Blocks that restore a state, from the rows of the dialect's ProgramText.
#pragma once

#include <map>

#include "isogloss/engine/program_text.hpp"
#include "state/program_point.hpp"

namespace isogloss::cli {

/// The fields of a state by their paths: names without quotes, numbers as JSON.
using StateFields = std::map<std::string, std::string, std::less<>>;
StateFields fields_of(const std::vector<ExplainedValue>& values);

/// Do the conditions hold? "PATH" is there, "!PATH" is not, "PATH=A|B", "PATH!=A", "PATH=@OTHER" as the field OTHER;
/// numbers by value.
bool holds(std::string_view when, const StateFields& state);

/// True when the dialect says how it writes a state.
bool has_preamble(const ProgramText& text);
/// One block a line. `layout` tells which values are lengths, which are written in the unit of the program.
std::string make_preamble(const ProgramText& text, const ProgramPoint& point, const Layout& layout);

}  // namespace isogloss::cli
