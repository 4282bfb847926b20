/// Text in the language of manual pages.
#pragma once

#include <string>
#include <string_view>

namespace isogloss::cli {

/// The text with everything escaped that troff would read as its own.
std::string roff(std::string_view text);
/// The same, filled: broken into lines, since troff fills them again; blank lines begin paragraphs.
std::string roff_paragraphs(std::string_view text);
/// Kept line by line, in a type for code.
std::string roff_example(std::string_view text);

}  // namespace isogloss::cli
