/// An explained block as questions are put to it: values by path, now and before, and the text of the lines that set
/// them.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <unordered_map>

#include "isogloss/engine/explain.hpp"

namespace isogloss::cli {

using Json = nlohmann::ordered_json;

/// Lines of programs, read when they are asked for.
class LineTexts {
 public:
  /// Without blanks at both ends; empty for what cannot be read again.
  std::string at(const ProgramLine& line);
  /// This text stands in place of the file.
  void give(const std::string& path, const std::string& text);

 private:
  struct File {
    std::string bytes;
    std::vector<std::size_t> begins;  ///< of lines
  };
  static File read(const std::string& path);
  static void find_lines(File& file);
  std::map<std::string, File> files_;
};

/// Does the text hold this code, with or without its zeros: G00, G0?
bool mentions(std::string_view text, std::string_view code);
/// What a machinist calls a section of the block document: "tool length compensation", "work offset".
std::string section_words(std::string_view section);

class Facts {
 public:
  /// `reports`: of the run, those of other lines among them.
  Facts(const ExplainedBlock& block, LineTexts& lines, std::span<const Diagnostic> reports = {});

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
  /// The first error of its line, else the first warning: "feed move without a feed rate: … [ISO-0302]"; empty: none.
  std::string report() const;
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
  /// What a machinist calls the work of a syntax: the code of the block that it uses, "G41"; the one in force that it
  /// serves, "G51.1 of line 2"; what its summary says, "tool length compensation (G43/G44/G49 and H)"; its own name at
  /// last.
  std::string function_of(const std::string& syntax) const;
  /// The summary of a syntax without its point; its own name where it has none.
  std::string summary_of(const std::string& syntax) const;

  /// Of the program: 25.4 where it is written in inch, else 1.
  double unit() const { return unit_mm_; }
  bool is_inch() const { return unit_mm_ != 1; }
  /// A length in the unit of the program: "170", "6.692913 inch (170 mm)".
  std::string length(double mm) const;
  /// "200 mm/min", "10 inch/min (254 mm/min)".
  std::string feed(double mm_min) const;
  /// Axis words in mm, as the program writes them: "X10 Y5"; "X2 Y1 inch (X50.8 Y25.4 mm)".
  std::string words(const std::vector<std::pair<char, double>>& axes) const;

 private:
  using Index = std::unordered_map<std::string_view, const ExplainedValue*>;
  static const ExplainedValue* find(const Index& index, const std::string& path) {
    const auto found = index.find(path);
    return found == index.end() ? nullptr : found->second;
  }
  static std::optional<double> number_of(const ExplainedValue* value);

  std::string code_served_by(const std::string& syntax) const;

  const ExplainedBlock& block_;
  LineTexts& lines_;
  std::span<const Diagnostic> reports_;
  Json document_;
  Index now_, before_;
  double unit_mm_ = 1;
};

}  // namespace isogloss::cli
