/// Values of a traced block with their writers and lines, and the way of its point to the machine.
#pragma once

#include "isogloss/engine/explain.hpp"
#include "run/frame_history.hpp"

namespace isogloss {

/// As JSON shows it: whole numbers without a point.
std::string number_text(double value);

class ValueOrigins {
 public:
  ValueOrigins(const LinkedDialect& linked, const Chain& chain) : linked_(linked), chain_(chain) {}

  /// The field behind a path of the JSON view: a list of codes stands for its first code, a transform for its entry.
  static ig_field field_of(const Document& document, const std::string& path);
  ExplainedValue describe(const Document& document, const std::string& path, const std::string& value) const;
  /// The alias of the syntax that wrote the field; empty: none.
  std::string writer_of(const Document& document, ig_field f) const;
  ProgramLine set_at(const Document& document, ig_field f) const;
  /// A name that the initial state has, too, counts from the line that programs it last.
  ProgramLine since(const Document& document, ig_field f, std::string_view name = {}) const;
  ExplainedLadder ladder(const Document& document, const SymbolTable& symbols, const FrameHistory& frames) const;
  /// The first name that the section has in the block; empty: none.
  static std::string label(const Document& document, const SymbolTable& symbols, std::string_view section);

 private:
  static ig_field label_of(const Document& document, std::string_view section);

  const LinkedDialect& linked_;
  const Chain& chain_;
};

}  // namespace isogloss
