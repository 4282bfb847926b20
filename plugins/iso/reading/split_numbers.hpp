#pragma once

namespace iso {

/// What a scanner does with a number that a blank divides: G5. 1 and X1. 5.
enum class SplitNumbers { error, join };
inline constexpr const char* split_numbers_meaning =
    "Blanks next to the decimal point of a number (G5. 1, X1. 5): an error, or ignored.";

}  // namespace iso
