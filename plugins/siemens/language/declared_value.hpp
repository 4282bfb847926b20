/// The value of an assignment to a variable, which its type decides how to read.
#pragma once

#include "language/frame_expression.hpp"

namespace siemens {

using namespace ig::cnc;

/// Reads the value at `position` and moves it behind: an expression, for AXIS also the bare name of an axis, for FRAME
/// links. Nothing, with a diagnostic, where there is none.
std::optional<Value> value_of(ig::Block& b, const Environment& environment, std::string_view text,
                              std::size_t& position, const Declared& type);

}  // namespace siemens
