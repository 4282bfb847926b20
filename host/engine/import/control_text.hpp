/// The text of a control's file as UTF-8.
#pragma once

#include <optional>
#include <string>

namespace isogloss {

/// A byte order mark tells UTF-8 or UTF-16; other text is UTF-8 where it is valid, and Latin-1 where it is not. Codes
/// of tape punches and serial lines are dropped (NUL beside a line end, DC1 to DC4, DEL, the byte 1A at the end), and
/// CR CR LF becomes CR LF. Nothing, with the reason, for bytes that are no text.
std::optional<std::string> text_of_control(std::string bytes, std::string& reason);

}  // namespace isogloss
