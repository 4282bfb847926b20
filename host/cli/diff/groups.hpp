/// What parts the two sides, by cause: how many blocks, which fields, the first examples.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diff/evidence.hpp"

namespace isogloss::cli::parting {

/// One value that both sides have differently; absent: empty.
struct Parting {
  std::string field;  ///< with the number of the stroke: "CompoundMotion.Items[4].ProgramXyz.Z"
  std::string a, b, unit;
  std::string writer_a, writer_b;  ///< syntaxes
};

struct PartedBlock {
  std::string file_a, file_b, text_a, text_b;
  std::uint32_t line_a = 0, line_b = 0;  ///< 0: that side has no such block
  std::vector<Parting> values;
};

struct FieldCount {
  std::uint64_t blocks = 0;
  bool is_direct = false;        ///< the cause acts on it; otherwise it follows from another field
  std::uint64_t last_block = 0;  ///< the number of the block that counted last
};

struct Group {
  /// What kind of cause: a syntax with rows or options that differ; different syntaxes; a value from before the first
  /// block; the text of two programs; blocks that only one side runs; a diagnostic; not known.
  enum class Kind : std::uint8_t { syntax, syntaxes, initial, text, blocks, diagnostic, unknown };
  Kind kind = Kind::unknown;
  std::string cause;  ///< the heading
  std::vector<Evidence> evidence;
  std::string syntax_a, syntax_b;
  std::string initial;                          ///< of an initial state: the field
  std::vector<std::string> codes;               ///< of the blocks in which it acts, the first few
  std::uint64_t blocks = 0, direct_blocks = 0;  ///< in the others, something follows from it
  std::map<std::string, FieldCount> fields;
  std::vector<PartedBlock> examples;              ///< a few
  std::uint64_t first_block = 0, last_block = 0;  ///< the numbers of the blocks that counted first and last
  std::uint64_t last_direct_block = 0;
  /// The first field that it makes differ, and the block: where a trial looks whether the difference is still there.
  std::string probe;
  PartedBlock probed;
  std::uint64_t probed_block = 0;  ///< the number of that block
  std::string beside;              ///< a code that only one side reports in that block, and which side; empty: none
  /// Of a cause that is no row and no option: what a second run has shown in which side B had it as side A has.
  Evidence::Trial trial = Evidence::Trial::none;
  bool acts_together = false;  ///< its rows and options remove the difference together, and none of them alone
};

std::string_view to_string(Group::Kind kind);

struct Report {
  std::string name_a, name_b;  ///< of the sides
  std::string program_a, program_b;
  std::uint64_t blocks_a = 0, blocks_b = 0;
  std::uint64_t parted = 0;  ///< blocks that differ, or that only one side has; and such with other diagnostics
  std::vector<Group> groups;
  std::vector<PartedBlock> all;         ///< with --all
  std::vector<std::size_t> all_groups;  ///< of `all`: the group of the first value
  bool is_probe_there = false;          ///< the difference of ComparisonOptions::probe
  bool is_probed = false;               ///< both sides have run its block
  bool has_more_causes = false;         ///< the last group holds what exceeded the number of groups
};

}  // namespace isogloss::cli::parting
