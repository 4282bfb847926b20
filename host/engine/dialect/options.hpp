/// Options as text, typed and checked against their declaration.
#pragma once

#include "isogloss/engine/linker.hpp"

namespace isogloss {

/// Empty when the text is not of the option's type, or outside its range or choices.
std::optional<OptionValue> parse_option(const ig_option_decl& option, std::string_view text);

/// "a number from 0 to 10", "one of s, ms": for a message.
std::string describe_option(const ig_option_decl& option);

/// A number as dialect files write it: decimal, no exponent, the whole text.
std::optional<double> parse_number(std::string_view text);

}  // namespace isogloss
