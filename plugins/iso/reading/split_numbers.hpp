#pragma once

namespace iso {

/// What a scanner does with G5. 1 and X1. 5.
enum class SplitNumbers { error, join };
inline constexpr const char* split_numbers_meaning =
    "Blanks inside a number beside its point (G5. 1, X1. 5): an error, or they do not count.";

}  // namespace iso
