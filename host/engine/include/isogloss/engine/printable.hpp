/// Text of programs and plugins for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace isogloss {

/// A control character that is not among `kept` is shown as \x1b, and a byte sequence that is not UTF-8 as U+FFFD.
std::string printable(std::string_view text, std::string_view kept = {});

}  // namespace isogloss
