/// Values of both sides: whether they are the same, and how they read.
#pragma once

#include <string>

#include "diff/match.hpp"
#include "diff/snapshot.hpp"

namespace isogloss::cli::parting {

/// Numbers are the same when rounding alone may part them.
bool are_same(double a, double b);
bool are_same(const Cell* a, const Snapshot& in_a, const Cell* b, const Snapshot& in_b);
/// With up to 6 decimals; "yes" and "no" for booleans. Empty: absent.
std::string value_text(const Cell* cell, const Snapshot& in, bool is_boolean);
/// With as many decimals as tell both apart.
std::string number_text(double value, int decimals = 6);

/// Which strokes of two lists belong together.
std::vector<Match> match_strokes(const StrokeList& a, const Snapshot& in_a, const StrokeList& b, const Snapshot& in_b);

}  // namespace isogloss::cli::parting
