/// What one run of a program tells an editor, and what its scanners read: kept until the text changes.
#pragma once

#include <array>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "isogloss/engine/scan.hpp"
#include "lsp/toolbox.hpp"

namespace isogloss::editors {

/// What is in force at the end of a line of the main file, when it ran last.
struct LineFacts {
  std::array<double, 6> machine{};
  std::uint32_t known = 0;              ///< a bit for each of X Y Z A B C
  std::uint32_t passes = 0;             ///< 0: no run has come here
  std::uint16_t motion = 0, cycle = 0;  ///< in Analysis::names; 0: none
  float feed_mm_min = 0;                ///< of the move of this line; 0: none
  bool moves = false, is_rapid = false;
};

struct Move {
  FlowStep::Kind kind = FlowStep::Kind::jump;
  std::string file, label, to_file;
  std::uint32_t line = 0, column = 0, to_line = 0;
};

struct VariableUse {
  std::string name, file;
  std::uint64_t scope = 0;
  std::uint32_t line = 0;
  bool is_write = false;
  std::string value;  ///< of the first use at this line, as text; empty: none
};

struct ToolUse {
  std::uint32_t line = 0;
  std::int64_t tool = 0;
};

struct RowUse {
  std::uint32_t line = 0;
  std::size_t dependency = 0;
  std::string row;
};

struct Analysis {
  std::vector<Diagnostic> diagnostics;
  std::size_t unlisted = 0;  ///< diagnostics beyond those that the settings allow
  bool is_cut = false;       ///< the time was over
  bool is_interrupted = false;
  std::vector<LineFacts> lines;  ///< by line - 1
  std::vector<std::string> names{std::string()};
  std::vector<Move> moves;
  std::vector<VariableUse> variables;
  std::vector<ToolUse> tools;
  std::vector<RowUse> rows;
  const LineFacts* at(std::uint32_t line) const {
    return line >= 1 && line <= lines.size() ? &lines[line - 1] : nullptr;
  }
};

/// Runs the text as the file `path`. `goes_on` is asked now and then; false interrupts the run.
Analysis analyse(const Setup& setup, const std::string& path, const std::string& text, const Settings& settings,
                 const std::function<bool()>& goes_on);

enum class TokenKind : std::uint8_t { code, word, comment, label, number, text };

/// A piece of the program's text by what reads it. Offsets in the document.
struct Token {
  std::size_t begin = 0, end = 0;
  TokenKind kind = TokenKind::text;
  std::uint32_t reader = 0;      ///< chain position + 1; 0: nobody
  ig_field field = IG_NO_FIELD;  ///< of codes and words
};

struct NamedPlace {
  std::string name;
  bool is_program = false;
  std::size_t begin = 0, end = 0;
  std::uint32_t line = 0;
};

struct Remark {
  std::string text;
  std::uint32_t line = 0;
};

struct ScanMap {
  std::vector<Token> tokens;  ///< in the order of the text
  std::vector<NamedPlace> labels;
  std::vector<Remark> comments;
  /// The tokens that lie in these offsets, as a range of indices.
  std::pair<std::size_t, std::size_t> between(std::size_t begin, std::size_t end) const;
};

class TextDocument;
ScanMap scan(const Setup& setup, const std::string& path, const TextDocument& text);

}  // namespace isogloss::editors
