/// Numbers as text for bulk output, where printing them is the larger part of the work.
#pragma once

#include <cstddef>
#include <cstdint>

namespace isogloss {

/// Room that the writers below may need at `out`.
inline constexpr std::size_t number_room = 32;

/// At most 6 decimals, rounded as printf("%.6f") does, zeros trimmed, no "-0". Returns the end of the text. Writes
/// nothing for a value that is not finite; beyond 1e15 the shortest form that reads back, which may have an exponent.
char* write_decimal(char* out, double value);

/// The shortest text that reads back to the same double; nothing for a value that is not finite.
char* write_exact(char* out, double value);

char* write_integer(char* out, std::int64_t value);

}  // namespace isogloss
