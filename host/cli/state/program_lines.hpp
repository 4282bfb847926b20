/// The text of a program by its lines, and which of them hold one block together.
#pragma once

#include <map>
#include <string>

#include "isogloss/engine/document.hpp"
#include "isogloss/engine/explain.hpp"

namespace isogloss::cli {

class ProgramLines {
 public:
  ProgramLines(std::string main_file, const std::string& main_text);

  /// A run has executed this block.
  void note(const BlockSource& source);
  /// The lines of the block that begins there, as they are written, without the end of the last; empty: unknown.
  std::string block(const ProgramLine& at) const;
  /// With the blocks right behind it that are alike up to the first point, but for their number at the beginning: of
  /// "7 CYCL DEF 5.0 POCKET" also "8 CYCL DEF 5.1 SET UP 2".
  std::string parts(const ProgramLine& at) const;

 private:
  const std::string* text_of(const std::string& file) const;

  std::map<ProgramLine, std::uint32_t, bool (*)(const ProgramLine&, const ProgramLine&)> further_;  // lines of a block
  mutable std::map<std::string, std::string> texts_;
};

/// The text from this line on. Lines end as in a run: LF, CR or both.
std::string from_line(const std::string& text, std::uint32_t line);

}  // namespace isogloss::cli
