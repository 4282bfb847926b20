/// What the scanners of a dialect read in each block of a text, also in those that no run reaches: for editors.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "isogloss/engine/runner.hpp"

namespace isogloss {

/// Bytes of the block's text that one scanner has read.
struct ScannedPiece {
  std::uint32_t begin = 0, end = 0;
  std::uint32_t reader = 0;  ///< chain position
};

/// A word or a code of the block, with its columns in the block's text.
struct ScannedWord {
  std::uint32_t begin = 0, end = 0;
  ig_field field = IG_NO_FIELD;
};

/// A name that the block has: a label, a sequence number, a program.
struct ScannedLabel {
  std::string name;  ///< in the form in which plugins compare names: "N10", "O3"
  bool is_program = false;
  std::uint32_t begin = 0, end = 0;  ///< of the piece whose scanner has named it
};

/// Everything in it is alive until the visitor returns.
struct ScannedBlock {
  std::uint32_t line = 0;    ///< from 1; of the text's first byte
  std::uint32_t column = 0;  ///< of the text's first byte, from 0
  std::string_view text;     ///< holds the ends of lines where several are one block
  std::span<const ScannedPiece> pieces;
  std::span<const ScannedWord> words;
  std::span<const ScannedLabel> labels;
  std::string_view comment;          ///< the comment of the block; empty: none
  std::uint32_t comment_reader = 0;  ///< chain position + 1 of the scanner that reads comments; 0: none
  std::uint32_t number_reader = 0;   ///< chain position + 1 of the scanner of the block's sequence number; 0: none
};

/// Calls `visit` for each block of the text, in its order, until it returns false. Nothing is built or reported. Throws
/// as Chain does when a syntax cannot be created.
void scan_blocks(const LinkedDialect& linked, Source& source, const std::string& name, const RunOptions& options,
                 const std::function<bool(const ScannedBlock&)>& visit);

}  // namespace isogloss
