/// Schemas of dialect files and block documents, made from the declarations of the loaded plugins.
#pragma once

#include <string>

namespace isogloss {

class Library;

/// XSD 1.0 of files of dialects and machines, and of table files in their namespace: an element for each syntax and
/// dependency of the library's plugins, with its options, ranges, rows and their texts. A Configure takes the names of
/// all syntaxes (and aliases, which begin with a small letter here) and each option of any of them.
std::string dialect_schema(const Library& library);

/// XSD 1.0 of table files that stand in no namespace (--tools, --offsets, src="…"): the same elements for dependencies.
std::string table_schema(const Library& library);

/// JSON Schema (draft 2020-12) of the block document: the standard sections and all fields that plugins declare.
std::string block_schema(const Library& library);

}  // namespace isogloss
