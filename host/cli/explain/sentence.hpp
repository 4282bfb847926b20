/// What a block does and why, in one sentence for a machinist.
#pragma once

#include "explain/facts.hpp"
#include "explain/strokes.hpp"

namespace isogloss::cli {

std::string sentence_of(const Facts& facts, const std::vector<Stroke>& strokes);
/// "machine X is -253.800 because G55 adds -161.8 (line 37)"; empty where the block moves nothing.
std::string machine_clause(const Facts& facts);
/// The axes of the program and the rotary axes whose values the block has changed: "X-92 Y-20 A30".
std::string changed_axes(const Facts& facts);

}  // namespace isogloss::cli
