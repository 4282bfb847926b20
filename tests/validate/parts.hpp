// A sound plugin of one syntax, one dependency and one importer, which the sources beside it spoil in one place each.
#pragma once

#include <isogloss.h>
#include <isogloss_import.h>
#include <isogloss_scan.h>

#include <cmath>
#include <cstring>
#include <string_view>

namespace parts {

inline ig_text text_of(std::string_view text) { return {text.data(), text.size()}; }

inline ig_field_decl field(const char* path, std::uint32_t access, ig_type type = IG_NUMBER) {
  return {sizeof(ig_field_decl), access, type, IG_LIFE_STANDARD, path, "", "A field.", nullptr};
}

/// Takes X, makes it the feed, and scans "X" with digits.
struct Self {
  ig_field x, feed, y, comment;
  double length = 1;
  bool is_wide = false;
  long blocks = 0, others = 0;
};

inline ig_status set_feed(Self& self, const ig_host* host, ig_block* block, double number) {
  host->set(block, self.feed, {.number = number});
  return IG_CHANGED;
}

inline const char* const page =
    "# PartSyntax\n\nMakes X the feed.\n\n"
    "| option | type | default | range | meaning |\n|---|---|---|---|---|\n"
    "| `length` | number | 1 | 0 to 10 | a length |\n| `width` | choice | `narrow` | `narrow`, `wide` | a width |\n\n"
    "## X becomes the feed\n\n#BeforeBuild:\n```json\n{\"Parsing\": {\"X\": 1, \"Y\": 2}}\n```\n"
    "#AfterBuild:\n```json\n{\"Parsing\": {\"Y\": 2}, \"Feedrate\": {\"FeedrateValue\": 1}}\n```\n";
inline const char* const file_page =
    "# PartFile\n\nReads \"key=length\".\n\n## Two rows\n\n#File: PART.TXT\n```\nPART\n1=2.5\n2=3\n```\n"
    "#Tables:\n```xml\n<PartTable>\n<Part id=\"1\" Length=\"2.5\"/>\n<Part id=\"2\" "
    "Length=\"3\"/>\n</PartTable>\n```\n";

}  // namespace parts
