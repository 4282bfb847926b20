/// What may stand where in a file of the dialects: elements, attributes, text. What may not is reported.
#pragma once

#include "dialect/xml_source.hpp"

namespace isogloss {

/// Passes diagnostics on and remembers whether one was an error.
class Report {
 public:
  explicit Report(DiagnosticSink& sink) : sink_(sink) {}
  void operator()(std::string_view code, Location where, std::initializer_list<std::string> arguments,
                  std::string hint = {}) {
    failed = true;
    sink_.add(host_diagnostic(code, std::move(where), arguments, std::move(hint)));
  }
  DiagnosticSink& sink() { return sink_; }
  bool failed = false;

 private:
  DiagnosticSink& sink_;
};

class XmlElements {
 public:
  XmlElements(const XmlSource& xml, Report& report) : xml_(xml), report_(report) {}

  /// The child elements; text between them is reported.
  std::vector<pugi::xml_node> elements(pugi::xml_node node);
  /// The child elements of these names, none of which has children; others are reported.
  std::vector<pugi::xml_node> leaves(pugi::xml_node node, const std::vector<std::string>& names);
  void only_attributes(pugi::xml_node node, const std::vector<std::string>& names);
  /// The attribute's value; empty, and reported, when it is missing or empty.
  std::string required(pugi::xml_node node, const char* attribute);
  /// The path that src names, below the folder of this file; empty, and reported, when it leads out.
  std::filesystem::path path_of_src(pugi::xml_node node);
  /// The name that `as` gives the element; without it, that of the element.
  std::string alias(pugi::xml_node node);
  void bad_value(pugi::xml_node node, const char* attribute, const char* wanted,
                 const std::vector<std::string>& words = {});
  void unknown(pugi::xml_node node, const std::vector<std::string>& names);
  /// False, and reported, when the element has an elder sibling of its name.
  bool once(pugi::xml_node node);

 protected:
  static std::string place(const Location& where);

  const XmlSource& xml_;
  Report& report_;
};

/// Namespace declarations, and what editors add to find the schema.
bool is_markup(std::string_view attribute);

std::vector<std::string> words(std::string_view text);

/// "did you mean …?", or nothing.
std::string meant(std::string_view name, const std::vector<std::string>& names);

/// A text of the file, cut to a length fit for a message.
std::string shown(std::string_view text);

}  // namespace isogloss
