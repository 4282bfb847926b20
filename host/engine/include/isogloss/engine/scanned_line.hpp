/// What scanners find ahead of the turn of their block, and the functions with which it is noted.
#pragma once

#include <array>
#include <cstddef>

#include "isogloss/engine/chain.hpp"
#include "isogloss_scan.h"

namespace isogloss {

/// A line that was scanned ahead. What was noted of it lies directly behind.
struct ScannedLine {
  std::uint64_t offset = 0;  ///< in the source
  std::uint32_t size = 0;    ///< bytes of its text
  std::uint16_t count = 0;   ///< notes
  bool is_left = false;      ///< to its turn: more than its text decides what is found
  bool has_read = false;     ///< a value that is carried from the blocks before
  const ig_word* notes() const { return reinterpret_cast<const ig_word*>(this + 1); }
};

/// The notes of the line that is being scanned: words, each with the chain position + 1 of its scanner as `reserved`.
struct LineNotes {
  static constexpr std::uint16_t most = 32;
  /// In `flags`: a value in place of a word; or a value that the scan has read, carried from the blocks before, which
  /// it has to be in its turn, too; or that this field has none.
  static constexpr std::uint32_t is_value = 1u << 31, was_read = 1u << 30, was_absent = 1u << 29;

  ScannedLine line;
  std::array<ig_word, most> words;

  void leave() { line.is_left = true; }
  /// Member by member: a word that is put together elsewhere is copied in larger pieces, and waits for smaller ones.
  void add(ig_field field, ig_value value, std::uint32_t flags, std::uint16_t scanner, std::uint16_t begin = 0,
           std::uint16_t end = 0) {
    if (line.count == most) return leave();
    ig_word& word = words[line.count++];
    word.field = field;
    word.begin = begin;
    word.end = end;
    word.value = value;
    word.flags = flags;
    word.reserved = scanner;
  }
};
static_assert(offsetof(LineNotes, words) == sizeof(ScannedLine));

/// For ChainSettings::host of a chain that scans ahead. What it scans is noted in Chain::notes.
const ig_host& ahead_table();

/// In place of the scan() of a syntax that is not asked ahead.
std::size_t leave_to_turn(void* self, const ig_host*, ig_block* block, const char*, std::size_t size, std::size_t);

}  // namespace isogloss
