/// The types of DEF and PROC.
#pragma once

#include <optional>
#include <string_view>

#include "language/variable.hpp"

namespace siemens {

/// The type whose name stands at `position`, which moves behind it: REAL, INT, BOOL, CHAR, STRING[n]; AXIS is kept as a
/// text. Nothing for FRAME and other names.
std::optional<Type> type_at(std::string_view text, std::size_t& position);

/// The value of a variable that has got none.
inline Value empty_value(Type type) { return {0, type, {}}; }

}  // namespace siemens
