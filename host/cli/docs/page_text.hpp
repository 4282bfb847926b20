/// The documentation pages of plugins, read by a Markdown library. Nothing in them reaches a reader as HTML.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "docs/addresses.hpp"

namespace isogloss::cli::docs {

/// A page whose file, "pages/drilling_cycle_syntax", is the base of its relative links.
struct PageText {
  std::string file;
  std::string markdown;
};

struct ShownText {
  std::string text;
  std::vector<std::string> dead_links;  ///< as written: shown as text, since nothing of the reference answers them
};

/// HTML below the page's title, which is left out. Names of parts, diagnostics and fields become links; a case stands
/// as what goes in beside what comes out, with the lines marked that differ.
ShownText text_as_html(const PageText& page, const Addresses& addresses);

/// Markdown below the page's title, with its raw HTML escaped.
ShownText text_as_markdown(const PageText& page, const Addresses& addresses);

/// Where a link of a page leads: the file of the reference, an address of the web, or empty.
std::string target_of_link(std::string_view link, const std::string& from_file, const Addresses& addresses,
                           std::string_view extension);

/// For the text or an attribute of HTML; what is not UTF-8, and control characters, become visible.
std::string escaped_html(std::string_view text);

/// Escaped, with a link at each name that stands in the reference.
std::string linked_html(std::string_view text, const std::string& from_file, const Addresses& addresses);

/// `<code>`, as a link where the whole of it is a name.
std::string code_html(std::string_view text, const std::string& from_file, const Addresses& addresses);

}  // namespace isogloss::cli::docs
