/// What a block moves, how, and why so: "moves to X10 at 200 mm/min (line 9), because G01 has been active since line
/// 9".
#pragma once

#include <string>

#include "explain/strokes.hpp"

namespace isogloss::cli {

/// A block of one motion.
std::string move_clause(const Facts& facts);
/// A block that moves by several steps.
std::string stroke_clause(const Facts& facts, const std::vector<Stroke>& strokes);

}  // namespace isogloss::cli
