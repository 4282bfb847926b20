/// Numbers that a blank divides at the decimal point: G5. 1 and X1. 5.
#pragma once

#include "reading/word_addresses.hpp"

namespace iso {

/// What a scanner does with such a number.
enum class SplitNumbers { error, join };
inline constexpr const char* split_numbers_meaning =
    "Blanks next to the decimal point of a number (G5. 1, X1. 5): an error, or ignored.";

constexpr bool is_number_part(char c) { return is_digit(c) || c == '.' || c == '+' || c == '-'; }

/// Sets the word before `position` anew where the text here continues its number: X1. 5 and X1 .5, but not X10 20, in
/// which an address is missing. Returns the end of the number; `position` where nothing is continued.
std::size_t join_split_word(ig::Block& b, std::string_view text, std::size_t position, const WordAddresses& addresses);

}  // namespace iso
