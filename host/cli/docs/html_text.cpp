// Pieces of HTML: what a plugin wrote, escaped, with links at the names that the reference knows.
#include <fmt/format.h>

#include "docs/page_text.hpp"
#include "isogloss/engine/printable.hpp"
#include "markup.hpp"

namespace isogloss::cli::docs {

namespace {

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

bool is_of_name(char c) { return is_letter_or_digit(c) || c == '_' || c == '.' || c == '-'; }

/// Names that are words of a text by themselves: "X" and "G" are not looked for.
const Address* find_name(std::string_view name, const Addresses& addresses) {
  if (name.size() < 4) return nullptr;
  for (const Kind kind : {Kind::part, Kind::diagnostic, Kind::field})
    if (const Address* const found = addresses.find(kind, name)) return found;
  return nullptr;
}

std::string link(const Address& to, const std::string& from_file, const std::string& label) {
  return fmt::format("<a href=\"{}\">{}</a>", relative_link(from_file, to, ".html"), label);
}

}  // namespace

std::string escaped_html(std::string_view text) { return escaped_xml(printable(text, "\n\t")); }

std::string linked_html(std::string_view text, const std::string& from_file, const Addresses& addresses) {
  std::string out;
  std::size_t done = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (!is_letter_or_digit(text[at])) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && is_of_name(text[end])) ++end;
    std::string_view name = text.substr(at, end - at);
    while (name.ends_with('.') || name.ends_with('-')) name.remove_suffix(1);
    if (const Address* const found = find_name(name, addresses)) {
      out += escaped_html(text.substr(done, at - done)) + link(*found, from_file, escaped_html(name));
      done = at + name.size();
    }
    at = end;
  }
  return out + escaped_html(text.substr(done));
}

std::string code_html(std::string_view text, const std::string& from_file, const Addresses& addresses) {
  const std::string shown = "<code>" + escaped_html(text) + "</code>";
  const Address* found = find_name(text, addresses);
  const bool is_code = text.find_first_of("0123456789") != std::string_view::npos;
  if (found == nullptr && is_code) found = addresses.find(Kind::code, text);
  return found == nullptr ? shown : link(*found, from_file, shown);
}

std::string target_of_link(std::string_view link, const std::string& from_file, const Addresses& addresses,
                           std::string_view extension) {
  if (link.starts_with("https://") || link.starts_with("http://")) return std::string(link);
  link = link.substr(0, link.find('#'));
  if (!link.ends_with(".md")) return {};
  link.remove_suffix(3);
  link.remove_prefix(link.rfind('/') + 1);  // whatever the folder was in the plugin's sources
  const std::string file = "pages/" + file_stem(link);
  return addresses.has_file(file) ? relative_link(from_file, {file, {}}, extension) : std::string();
}

}  // namespace isogloss::cli::docs
