/// Schemas of dialect files and block documents, made from the declarations of the loaded plugins.
#pragma once

#include <string>

namespace isogloss {

class Library;

/// XSD 1.0 of dialect files and of the table files beside them: an element for each syntax and dependency of the
/// library's plugins, with its options, ranges, rows and their texts.
std::string dialect_schema(const Library& library);

/// JSON Schema (draft 2020-12) of the block document: the standard sections and all fields that plugins declare.
std::string block_schema(const Library& library);

}  // namespace isogloss
