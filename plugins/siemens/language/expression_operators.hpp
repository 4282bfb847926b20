/// What the operators of an expression need to know of a value, and how << writes it.
#pragma once

#include <cmath>
#include <string>

#include "language/variable.hpp"

namespace siemens {

/// The text of a value, as << joins it: the shortest digits that give the number back, 1 and 0 for TRUE and FALSE.
std::string text_of(const Value& v);

/// True for numbers on which B_AND, B_OR, B_XOR and B_NOT work: whole ones of 32 bits, with or without a sign.
inline bool is_bits(double n) { return n == std::floor(n) && std::fabs(n) <= 2147483648.0 * 2; }

}  // namespace siemens
