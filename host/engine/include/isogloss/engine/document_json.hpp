/// The document as JSON, as cases, apply, explain and the block stream show it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <set>

#include "isogloss/engine/document.hpp"

namespace isogloss {

using Json = nlohmann::ordered_json;

/// Fills the document from JSON: every value present and fresh. What the layout does not know is returned, for
/// show() to pass through. A value of a wrong type throws std::runtime_error with its JSON path.
Json load_json(const Json& json, Document& document, SymbolTable& symbols);

/// All present fields. Sections in their order; no null, no empty section. With `sections`, only these.
Json show_json(const Document& document, const SymbolTable& symbols, const std::set<std::string>* sections = nullptr);

/// The sections (first part of the path) in which the syntax at chain position `position` wrote, or anything fresh.
std::set<std::string> written_sections(const Document& document, std::uint16_t writer);

}  // namespace isogloss
