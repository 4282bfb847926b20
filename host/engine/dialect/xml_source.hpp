/// An XML file in memory in which every element and attribute knows its line and column.
#pragma once

#include <filesystem>
#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/dialect.hpp"

namespace isogloss {

/// What one dialect with all that it extends and includes may read.
struct XmlBudget {
  static constexpr std::size_t file_bytes = std::size_t{16} << 20;
  static constexpr int depth = 64;
  static constexpr std::size_t attributes = 256;  ///< of one element
  static constexpr std::size_t chain = 4096;      ///< elements and edits of one file
  std::size_t bytes_left = std::size_t{64} << 20;
  const UnsavedFiles* unsaved = nullptr;  ///< texts that take the place of files; null: none
};

/// UTF-8 without a document type, read more strictly than by pugixml: each fault that pugixml ignores is reported with
/// its place.
/// A pipe in a searched folder would block the run; a pipe that the user names is read.
enum class Pipes : std::uint8_t { refuse, read };

class XmlSource {
 public:
  /// Empty, and reported at `asked_at` (the place that named the file), when the file cannot be read; reported at its
  /// own place when it is not well-formed.
  static std::unique_ptr<XmlSource> open(const std::filesystem::path& file, const Location& asked_at, XmlBudget& budget,
                                         DiagnosticSink& sink, Pipes pipes = Pipes::refuse);
  static std::unique_ptr<XmlSource> parse(std::string file, std::string text, DiagnosticSink& sink);
  static std::string mismatch(const XmlSource& source, std::string_view text, std::size_t offset);

  pugi::xml_node root() const { return document_.document_element(); }
  const std::string& file() const { return file_; }
  /// The '<' of an element; the first byte of a text.
  Location at(pugi::xml_node node) const;
  /// The first byte of the attribute's name; the element when it has no such attribute.
  Location at(pugi::xml_node element, std::string_view attribute) const;

 private:
  XmlSource(std::string file, std::string text);
  Location at_offset(std::size_t offset) const;
  bool check_text(DiagnosticSink& sink) const;
  bool check_nodes(DiagnosticSink& sink) const;
  bool check_tag(pugi::xml_node element, DiagnosticSink& sink) const;

  std::string file_;
  std::string text_;
  std::vector<std::size_t> lines_;  // offset of each line's first byte
  pugi::xml_document document_;
};

/// For writers of XML: adds an attribute after those that the element has.
inline void set_attribute(pugi::xml_node element, const char* name, const std::string& value) {
  element.append_attribute(name).set_value(value.c_str());
}

}  // namespace isogloss
