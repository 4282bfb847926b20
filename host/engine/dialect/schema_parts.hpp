/// What the schemas of dialect files and of table files are put together from.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "isogloss_import.h"

namespace isogloss {

/// The text of the part that no plugin changes.
const char* dialect_schema_frame();

/// A new element in `parent`, with the attribute `name` where one is given.
pugi::xml_node add_element(pugi::xml_node parent, const char* element, const std::string& name = {});
void add_documentation(pugi::xml_node node, const std::string& text);
void add_type(pugi::xml_node attribute, const char* type);
/// The anonymous type of an attribute: a restriction of `base`.
pugi::xml_node restrict_to(pugi::xml_node attribute, const char* base);
/// Bounds that are infinite stay away.
void add_range(pugi::xml_node restriction, double minimum, double maximum);
std::string with_unit(const char* doc, const char* unit);

/// The option of one element: its type, range or words, its default and text.
void add_option(pugi::xml_node type, const ig_option_decl& option);

/// An option of one name, and whose it is.
using OwnedOption = std::pair<const char*, const ig_option_decl*>;
/// The option of an element that stands for several others, as Configure does: what any of its owners takes.
void add_shared_option(pugi::xml_node type, const std::vector<OwnedOption>& owned);

/// A name and its text, for a list that an editor shows.
using NamedText = std::pair<std::string, std::string>;
/// A type that takes these names and nothing else; with `more` also what that type takes.
void add_name_type(pugi::xml_node schema, const char* name, const std::vector<NamedText>& names,
                   const char* more = nullptr);

}  // namespace isogloss
