/// Where in the tags of an XML text a place is. The text is being typed: it need not be well-formed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace isogloss::editors {

bool is_xml_name(char c);

/// Where in a tag the place is.
struct TagContext {
  enum class Part : std::uint8_t { none, element, attribute, value } part = Part::none;
  std::string element, attribute;
  std::size_t begin = 0, end = 0;  ///< of the name or value that stands there
};

/// Part::none outside of tags, and in comments.
TagContext context_at(std::string_view text, std::size_t offset);

}  // namespace isogloss::editors
