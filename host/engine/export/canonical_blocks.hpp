/// Writes the blocks of a canonical program: rows of the dialect's ProgramText, filled with values.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "export/text_buffer.hpp"
#include "isogloss/engine/canonical.hpp"

namespace isogloss {

class Document;

class CanonicalBlocks {
 public:
  struct Value {
    std::string_view name;
    double number;
  };
  using Values = std::vector<Value>;

  CanonicalBlocks(Output& output, const ProgramText& text, bool is_exact, DiagnosticSink& sink)
      : buffer_(output), text_(text), is_exact_(is_exact), sink_(sink) {}

  void begin();
  /// The rows behind the last block; false when they cannot be written.
  bool end();
  bool ok() const { return buffer_.ok(); }
  /// The block of the program whose motions follow.
  void at(const Document& document) { document_ = &document; }

  /// The row "what which"; reported where the dialect has none.
  void write(std::string_view what, const Values& values, std::string_view which = {});
  void put(const ProgramText::Row& row, const Values& values);
  void report(std::string_view code, std::initializer_list<std::string> arguments);

 private:
  void write_all(std::string_view part);
  void name_file();

  TextBuffer buffer_;
  const ProgramText& text_;
  const bool is_exact_;
  DiagnosticSink& sink_;
  const Document* document_ = nullptr;
  std::string file_;
};

}  // namespace isogloss
