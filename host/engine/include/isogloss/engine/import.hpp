/// Reads the controls' own table and backup files through the plugins' importers, and writes such files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "isogloss/engine/dialect.hpp"
#include "isogloss/engine/library.hpp"

namespace isogloss {

/// Something in a file that its importer does not read.
struct UnusedPart {
  std::string what;
  std::string why;
  Location first;
  std::uint64_t count = 0;
};

/// What a file gave.
struct ImportedFile {
  const ig_importer* importer = nullptr;
  std::vector<DependencyElement> tables;  ///< one for each dependency, in the order in which the file names them
  std::vector<UnusedPart> unused;
};

/// How sure the importers are of a text, the surest first; those that are sure it is not theirs are left out.
struct RecognisedFormat {
  const ig_importer* importer;
  std::uint32_t confidence;  ///< 1 to 100
};
std::vector<RecognisedFormat> recognise(const std::string& text, const std::string& file_name, const Library& library);

/// Reads the file with the importer that `asked` names, or with the surest one. Empty, and reported, when no importer
/// reads it. Importers are those of all plugins in the library's folders.
std::optional<ImportedFile> import_file(const Import& asked, Library& library, DiagnosticSink& sink);

/// The same from bytes; `asked.file` names them.
std::optional<ImportedFile> import_bytes(const Import& asked, std::string bytes, Library& library,
                                         DiagnosticSink& sink);

/// The beginning of a file, as importers see it when they are asked; nothing for one that is no text.
std::optional<std::string> head_of_control_file(const std::filesystem::path& file);

/// What an importer tells of a file that is no text; empty where none knows it, and for texts.
std::string what_is_no_text(const std::filesystem::path& file, Library& library);

/// The files that an import names: the file itself, or all files below the folder, sorted. A file outside it, to which
/// a link leads, and what cannot be listed are reported and left out.
std::vector<std::filesystem::path> files_of(const Import& asked, DiagnosticSink& sink);

/// The tables as XML: one <Dependencies> that a machine includes. With `sources` a comment says of each file and line
/// what it gave.
std::string write_tables(const std::vector<DependencyElement>& tables, bool sources);

/// A file of this format with the rows of these tables. Empty, and reported, when the importer cannot write. What has
/// no place in the file is added to `unused`.
std::optional<std::string> export_tables(const Import& asked, const std::vector<DependencyElement>& given,
                                         Library& library, std::vector<UnusedPart>& unused, DiagnosticSink& sink);

}  // namespace isogloss
