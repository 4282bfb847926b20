/// The mark that editors of Windows put before the first line of UTF-8 text.
#pragma once

#include <string_view>

namespace isogloss {

inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The text behind its mark; all of it where it has none.
inline std::string_view behind_byte_order_mark(std::string_view text) {
  return text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text;
}

}  // namespace isogloss
