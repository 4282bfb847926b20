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
  std::string out;
  for (const char c : escaped_xml(printable(text, "\n\t"))) c == '\n' ? out += "&#10;" : out += c;
  return out;
}

}  // namespace isogloss::cli
