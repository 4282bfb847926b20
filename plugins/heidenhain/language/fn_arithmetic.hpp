/// FN 0 to FN 8 and FN 13: a Q parameter gets a value, a root, a sine or the result of two values. Angles in degrees.
#pragma once

#include "language/parameter_reader.hpp"

namespace heidenhain {

struct FnResult {
  ParameterReader::Target target;
  double value;  ///< infinite or NaN where the operation has no result
};

/// Reads and computes function `number`, whose words begin at `position`; nothing, with a diagnostic, where a part of
/// it is missing.
std::optional<FnResult> compute_fn(const ParameterReader& reader, std::size_t position, unsigned number);

}  // namespace heidenhain
