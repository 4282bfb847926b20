/// The types of DEF and PROC.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "language/variable.hpp"

namespace siemens {

inline constexpr std::uint32_t longest_string = 1000;

/// The type whose name stands at `position`, which moves behind it: REAL, INT, BOOL, CHAR, STRING[n], AXIS, FRAME.
/// Nothing for other names, and for a length that is not a whole number from 1 to 1000.
std::optional<Declared> type_at(std::string_view text, std::size_t& position);

/// STRING[12], as in a definition.
std::string type_text(const Declared& type);

}  // namespace siemens
