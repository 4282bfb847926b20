/// One run of a program in the test's own process.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "isogloss/engine/motion.hpp"
#include "isogloss/engine/runner.hpp"
#include "program.hpp"

namespace isogloss::properties {

/// Line and column of a block: a line may hold several, of which some are executed.
using Place = std::pair<std::uint32_t, std::uint32_t>;

struct Outcome {
  std::string motions;  ///< CSV
  std::vector<Diagnostic> diagnostics;
  std::set<Place> executed;
  bool has_jumps = false;
};

RunOptions options_of(const Case& program);
Outcome run_text(const Case& program, const std::string& text);

/// A block of the text as the scanners take it apart.
struct Block {
  struct Piece {
    std::size_t begin = 0, end = 0;  ///< bytes of the text
    bool is_word = false;            ///< one word or one code alone
    bool is_comment = false, is_number = false, is_label = false;
  };
  std::uint32_t line = 0, column = 0;
  std::size_t begin = 0, end = 0;  ///< bytes of the text
  std::vector<Piece> pieces;
  std::vector<std::pair<std::size_t, std::size_t>> words;  ///< bytes of the text
};
std::vector<Block> blocks_of(const Case& program, const std::string& text);

/// "FAN-0121 at line 3: …" for people.
std::string shown(const Diagnostic& diagnostic);

}  // namespace isogloss::properties
