/// Reads numbers that name something (a tool, a row of a table), which are whole and not negative.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

namespace ig::cnc {

/// The number as an integer; nothing where it is negative, has a fraction or exceeds 99999999.
inline std::optional<std::int64_t> whole_number(double value) {
  if (value < 0 || value > 99999999 || value != std::floor(value)) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

}  // namespace ig::cnc
