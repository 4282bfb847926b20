#include "lsp/tag_context.hpp"

#include <algorithm>

namespace isogloss::editors {

namespace {

bool is_xml_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

}  // namespace

bool is_xml_name(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '-' || c == '.';
}

TagContext context_at(std::string_view text, std::size_t offset) {
  TagContext out;
  const std::size_t open = offset == 0 ? std::string_view::npos : text.rfind('<', offset - 1);
  if (open == std::string_view::npos || text.substr(open, 2) == "<?") return out;
  const std::size_t comment = text.rfind("<!--", offset);
  if (comment < offset && text.find("-->", comment) >= offset) return out;
  std::size_t at = open + 1;
  if (at < offset && text[at] == '/') ++at;
  const std::size_t name = at;
  while (at < text.size() && is_xml_name(text[at])) ++at;
  out.element = text.substr(name, at - name);
  out.begin = name;
  out.end = at;
  out.part = TagContext::Part::element;
  char quote = 0;
  for (; at < offset; ++at) {
    const char c = text[at];
    if (quote != 0) {
      if (c == quote) quote = 0;
      continue;
    }
    if (c == '>') return {};
    if (c == '"' || c == '\'') {
      quote = c;
      out.begin = at + 1;
    } else if (is_xml_name(c) && (is_xml_blank(text[at - 1]) || out.part == TagContext::Part::element)) {
      out.begin = at;
      while (at < text.size() && is_xml_name(text[at])) ++at;
      out.attribute = text.substr(out.begin, at - out.begin);
      out.end = at--;
    } else if (is_xml_blank(c)) {
      out.attribute.clear();
      out.begin = out.end = at + 1;
    }
    out.part = TagContext::Part::attribute;
  }
  if (quote != 0) {
    out.part = TagContext::Part::value;
    out.end = std::min(text.find_first_of("\"'<>", offset), text.size());
  }
  out.end = std::max(out.end, offset);
  return out;
}

}  // namespace isogloss::editors
