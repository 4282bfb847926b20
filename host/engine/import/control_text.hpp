/// The text of a control's file as UTF-8.
#pragma once

#include <optional>
#include <string>

namespace isogloss {

/// A byte order mark tells UTF-8 or UTF-16; other text is UTF-8 where it is valid, and Latin-1 where it is not. A NUL
/// after the last line is the end of a punch-out and is dropped. Nothing, with the reason, for bytes that are no text.
std::optional<std::string> text_of_control(std::string bytes, std::string& reason);

}  // namespace isogloss
