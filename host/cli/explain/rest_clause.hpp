/// Why a block moves nothing: what became of its words, and what it has set instead.
#pragma once

#include <string>

#include "explain/facts.hpp"

namespace isogloss::cli {

std::string rest_clause(const Facts& facts);
/// "G91 sets PositioningMode.Mode = …": codes of a block that does something else besides, without moving.
std::vector<std::string> mode_clauses(const Facts& facts);
/// The first three, and how many more.
std::string list_of(const std::vector<std::string>& parts);
/// All of them: "G17, G21 and G90".
std::string series_of(const std::vector<std::string>& parts);
/// "#102 = 10, #103 = 5": the variables that the block writes.
std::string written_text(const Facts& facts);

}  // namespace isogloss::cli
