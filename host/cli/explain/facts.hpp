/// An explained block as questions are put to it: values by path, now and before, and the text of the lines that set
/// them.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_map>

#include "isogloss/engine/explain.hpp"

namespace isogloss::cli {

using Json = nlohmann::ordered_json;

/// Lines of programs, read when they are asked for.
class LineTexts {
 public:
  /// Without blanks at both ends; empty for what cannot be read again.
  std::string at(const ProgramLine& line);

 private:
  struct File {
    std::string bytes;
    std::vector<std::size_t> begins;  ///< of lines
  };
  static File read(const std::string& path);
  std::map<std::string, File> files_;
};

/// Does the text hold this code, with or without its zeros: G00, G0?
bool mentions(std::string_view text, std::string_view code);
/// "ToolHeightCompensation" → "tool height compensation".
std::string prose(std::string_view section);

class Facts {
 public:
  Facts(const ExplainedBlock& block, LineTexts& lines);

  const ExplainedBlock& block() const { return block_; }
  const Json& document() const { return document_; }
  /// nullptr where the block has no such value.
  const ExplainedValue* now(const std::string& path) const { return find(now_, path); }
  const ExplainedValue* before(const std::string& path) const { return find(before_, path); }
  std::optional<double> number(const std::string& path) const { return number_of(now(path)); }
  std::optional<double> number_before(const std::string& path) const { return number_of(before(path)); }
  /// The name or text of the value; empty where there is none.
  std::string text(const std::string& path) const;
  /// The value is another one than before the block, or there was none.
  bool has_changed(const std::string& path) const;
  /// A word of the block with this name, or nullptr.
  const ExplainedWord* word(const std::string& name) const;

  /// "line 36", "line 4 of O9001.nc", "before the first block".
  std::string place(const ProgramLine& line) const;
  std::string line_text(const ProgramLine& line) const { return lines_.at(line); }
  bool is_here(const ProgramLine& line) const {
    return line.line == block_.where.line && line.file == block_.where.file;
  }
  /// What a programmer calls a rung: its code where the line that set it holds the code, else its section in words.
  std::string name_of(const ExplainedRung& rung) const;

 private:
  using Index = std::unordered_map<std::string_view, const ExplainedValue*>;
  static const ExplainedValue* find(const Index& index, const std::string& path) {
    const auto found = index.find(path);
    return found == index.end() ? nullptr : found->second;
  }
  static std::optional<double> number_of(const ExplainedValue* value);

  const ExplainedBlock& block_;
  LineTexts& lines_;
  Json document_;
  Index now_, before_;
};

}  // namespace isogloss::cli
