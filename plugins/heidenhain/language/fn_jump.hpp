/// FN 9 to FN 12: a jump to a label under a condition.
#pragma once

#include "language/parameter_reader.hpp"

namespace heidenhain {

/// Reads function `number`, whose words begin at `position`, and jumps where its condition holds. A part that is
/// missing and a label that does not exist are reported; the run then continues with the next block.
void jump_by_fn(const ParameterReader& reader, std::size_t position, unsigned number);

}  // namespace heidenhain
