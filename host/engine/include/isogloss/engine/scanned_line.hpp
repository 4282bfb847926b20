/// What scanners find ahead of the turn of their block, and the functions with which it is noted.
#pragma once

#include <array>
#include <cstddef>

#include "isogloss/engine/chain.hpp"
#include "isogloss_scan.h"

namespace isogloss {

/// A line that was scanned ahead. Directly behind lie what its scanners found, and the values that they have read.
struct ScannedLine {
  std::uint64_t offset = 0;  ///< in the source
  std::uint32_t size = 0;    ///< bytes of its text
  std::uint16_t behind = 0;  ///< bytes that follow
  std::uint8_t reads = 0;    ///< values
  bool is_left = false;      ///< to its turn, with nothing behind: more than its text decides what is found

  /// A value that is carried from the blocks before, which it has to be in its turn, too; or that this field has none.
  struct Read {
    ig_value value;
    ig_field field;
    std::uint32_t is_there;
  };
  const Document::Summary& summary() const { return *reinterpret_cast<const Document::Summary*>(this + 1); }
  const Read* read() const {
    return reinterpret_cast<const Read*>(reinterpret_cast<const std::byte*>(this + 1) + summary().bytes());
  }
  std::size_t bytes() const { return sizeof *this + behind; }
};

/// What is noted of the line that is being scanned.
struct LineNotes {
  static constexpr std::uint8_t most_reads = 32;

  ScannedLine line;
  Document::Summary summary;
  std::array<ScannedLine::Read, most_reads> reads;  // complete() puts them directly behind the summary

  void leave() { line.is_left = true; }
  /// Member by member: what is put together elsewhere is copied in larger pieces, and waits for smaller ones.
  void add(ig_field field, bool is_there, ig_value value) {
    if (line.reads == most_reads) return leave();
    ScannedLine::Read& read = reads[line.reads++];
    read.value = value;
    read.field = field;
    read.is_there = is_there ? 1 : 0;
  }
  /// When the whole line has been scanned into this document, which has its summary here.
  void complete(Document& document) {
    if (line.is_left) return;
    if (!document.hand_over()) return leave();
    const std::size_t bytes = summary.bytes();
    auto* const behind = reinterpret_cast<ScannedLine::Read*>(reinterpret_cast<std::byte*>(&summary) + bytes);
    for (std::size_t i = 0; i < line.reads; ++i) behind[i] = reads[i];
    line.behind = static_cast<std::uint16_t>(bytes + line.reads * sizeof(ScannedLine::Read));
  }
};
static_assert(offsetof(LineNotes, summary) == sizeof(ScannedLine) && sizeof(LineNotes) <= UINT16_MAX);

/// For ChainSettings::host of a chain that scans ahead. What it scans is noted in Chain::notes.
const ig_host& ahead_table();

/// In place of the scan() of a syntax that is not asked ahead.
std::size_t leave_to_turn(void* self, const ig_host*, ig_block* block, const char*, std::size_t size, std::size_t);

}  // namespace isogloss
