/// The shape of a block document: which fields there are, their dense ids, and how they show as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "isogloss.h"

namespace isogloss {

/// Of maps whose keys are strings and which are asked with views.
struct TextHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view s) const { return std::hash<std::string_view>{}(s); }
};

/// Interned names; ids from 1. One per chain, since a run may meet new names.
class SymbolTable {
 public:
  ig_symbol intern(std::string_view name);
  std::string_view text(ig_symbol symbol) const { return symbol < names_.size() ? names_[symbol] : names_[0]; }
  std::size_t size() const { return names_.size() - 1; }
  SymbolTable();
  SymbolTable(const SymbolTable& other);
  SymbolTable& operator=(const SymbolTable&) = delete;

 private:
  std::vector<std::string_view> names_;  // into ids_' keys, whose nodes stay
  std::unordered_map<std::string, ig_symbol, TextHash, std::equal_to<>> ids_;
};

/// A value of this life is present again in the next block.
constexpr bool is_carried(ig_life life) { return life == IG_LIFE_MODAL || life == IG_LIFE_FRAME; }

/// A field as one syntax or the host's list of standard sections declares it.
struct FieldInfo {
  std::string path;  ///< "Feedrate.FeedrateValue"; in a list: the path inside a record, "MotionEvent.Form"
  ig_type type = IG_NUMBER;
  ig_life life = IG_LIFE_BLOCK;
  std::string unit;
  std::string doc;
  bool hidden = false;  ///< switches, and values from before the block: never shown
  ig_field previous_of = IG_NO_FIELD;
};

struct ListInfo {
  std::string path;  ///< "CompoundMotion.Items"
  std::vector<FieldInfo> fields;
};

/// The most syntaxes of a chain (IG-0216).
inline constexpr std::size_t longest_chain = 1024;

// Masks of the syntaxes that build, in 64-bit words: a bit for each. The first two words hold nearly every chain, so
// they end with two flags, and what lies beyond them is looked at only where the first flag is raised.
inline constexpr std::uint64_t wakes_beyond = std::uint64_t{1} << 62;     ///< of word 1: a bit of a later word is set
inline constexpr std::uint64_t holds_far_words = std::uint64_t{1} << 63;  ///< of word 1; Document::find_open_words()
/// The bit of a syntax, by its distance from LinkedDialect::first_build.
constexpr std::size_t wake_bit(std::size_t place) { return place < 126 ? place : place + 2; }
/// Words of the masks for so many syntaxes.
constexpr std::uint32_t wake_words_for(std::size_t syntaxes) {
  return syntaxes <= 126 ? 2 : static_cast<std::uint32_t>(wake_bit(syntaxes - 1) / 64 + 1);
}
inline constexpr std::size_t most_wake_words = wake_words_for(longest_chain);

/// Record fields carry their list in the upper half: list_bit | list << 16 | index.
inline constexpr ig_field list_bit = 0x80000000u;
constexpr ig_field record_field(std::size_t list, std::size_t index) {
  return list_bit | static_cast<ig_field>(list << 16) | static_cast<ig_field>(index);
}
constexpr bool is_record_field(ig_field f) { return (f & list_bit) != 0; }
constexpr std::size_t list_of(ig_field f) { return (f & ~list_bit) >> 16; }
constexpr std::size_t index_in_record(ig_field f) { return f & 0xffffu; }

class Layout {
 public:
  std::vector<FieldInfo> fields;  ///< by id: modal ones first
  std::vector<ListInfo> lists;
  std::vector<ig_field> shown;       ///< ids in the order in which JSON shows them (codes and transforms apart)
  std::vector<ig_field> transforms;  ///< in chain order

  std::optional<ig_field> find(std::string_view path) const;
  /// IG_NO_FIELD when the chain has no such field.
  ig_field id(std::string_view path) const { return find(path).value_or(IG_NO_FIELD); }
  /// A field of a list's records: record("CompoundMotion.Items", "ProgramXyz.X").
  ig_field record(std::string_view list, std::string_view path) const;
  /// What a code's field shows: the part after "Parsing.Flags." or "Parsing.".
  static std::string_view code_name(std::string_view path);
  bool is_word(ig_field f) const { return fields[f].life == IG_LIFE_WORD && fields[f].type == IG_NUMBER; }

  void index();  ///< after filling

 private:
  std::unordered_map<std::string_view, ig_field> ids_;
};

/// The standard sections: fields that consumers know by name.
const std::vector<FieldInfo>& standard_fields();
/// The records of the standard lists.
const std::vector<ListInfo>& standard_lists();
/// The order in which sections show.
const std::vector<std::string>& section_order();

}  // namespace isogloss
