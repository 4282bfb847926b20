#include "markup.hpp"

#include "isogloss/engine/printable.hpp"

namespace isogloss::cli {

std::string escaped_xml(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  return out;
}

std::string visible_xml(std::string_view text) {
  std::string shown = printable(text, "\n\t"), out;
  // U+FFFE and U+FFFF, which are UTF-8 but no characters of XML.
  for (std::size_t at = 0; (at = shown.find("\xef\xbf", at)) != std::string::npos; at += 3)
    if (shown.compare(at + 2, 1, "\xbd") > 0) shown[at + 2] = '\xbd';
  for (const char c : escaped_xml(shown)) c == '\n' ? out += "&#10;" : out += c;
  return out;
}

}  // namespace isogloss::cli
