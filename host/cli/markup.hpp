/// Text that becomes a part of XML, HTML or SVG.
#pragma once

#include <string>
#include <string_view>

namespace isogloss::cli {

/// For the text or an attribute of XML.
std::string escaped_xml(std::string_view text);

/// The same for what programs and plugins wrote, which may hold any byte: what is not UTF-8, and control characters,
/// become visible; a line break stays one in an attribute, too.
std::string visible_xml(std::string_view text);

}  // namespace isogloss::cli
