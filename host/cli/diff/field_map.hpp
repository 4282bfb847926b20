/// One numbering for the fields of two layouts, by path: what both chains call the same is the same number.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "isogloss/engine/linker.hpp"

namespace isogloss::cli::parting {

inline constexpr std::uint32_t no_field = 0xffffffffu;

/// A field of the block, or of the records of a list ("CompoundMotion.Items[].ProgramXyz.Z").
struct CommonField {
  std::string path, unit;
  ig_type type = IG_NUMBER;
  bool is_shown = false;  ///< in the block document; the others only lead from cause to effect
  bool is_read = false;   ///< a word or code of the text
};

class FieldMap {
 public:
  /// `ignored`: sections and fields that are not compared, by path.
  FieldMap(const LinkedDialect& a, const LinkedDialect& b, const std::vector<std::string>& ignored);

  /// Is there such a section or field?
  bool has_ignored(const std::string& path) const { return found_.contains(path); }

  std::vector<CommonField> fields;
  std::vector<std::string> lists;
  std::vector<std::uint32_t> list_field;  ///< by list: stands for a whole record, where only one side has it
  /// By side and the field's id in its layout; no_field: a copy from before the block, or not compared.
  std::array<std::vector<std::uint32_t>, 2> of_field;
  std::array<std::vector<std::uint32_t>, 2> of_list;                 ///< by side and list
  std::array<std::vector<std::vector<std::uint32_t>>, 2> of_record;  ///< by side, list and field of a record
  /// By side and position in the chain: which fields the syntax reads, which from before the
  /// block, and which it takes.
  std::array<std::vector<std::vector<bool>>, 2> reads, reads_before, takes;
  /// By side and position: does it write this field, in the block or in a record?
  std::array<std::vector<std::vector<bool>>, 2> writes;

 private:
  std::uint32_t number_of(const std::string& path, const FieldInfo& field);
  void number_fields(int side, const Layout& layout);
  void note_reads(int side, const LinkedDialect& linked);

  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::vector<std::string> ignored_;
  std::set<std::string> found_;  // of these
};

}  // namespace isogloss::cli::parting
