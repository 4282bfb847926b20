/// Options as text, typed and checked against their declaration.
#pragma once

#include <functional>
#include <span>

#include "isogloss/engine/linker.hpp"

namespace isogloss {

/// Empty when the text is not of the option's type, or outside its range or choices.
std::optional<OptionValue> parse_option(const ig_option_decl& option, std::string_view text);

/// "a number from 0 to 10", "one of s, ms": for a message.
std::string describe_option(const ig_option_decl& option);

/// Takes a fault of an option: code, place, arguments, hint.
using OptionFault =
    std::function<void(std::string_view, const Location&, std::initializer_list<std::string>, const std::string&)>;

/// The values of the declared options, by declaration; what is wrong with the given ones is reported.
std::vector<OptionValue> read_options(const OptionFault& report, const std::string& owner, const Location& where,
                                      std::span<const ig_option_decl> declared, const std::vector<Attribute>& given);

/// A number as dialect files write it: decimal, no exponent, the whole text.
std::optional<double> parse_number(std::string_view text);

}  // namespace isogloss
