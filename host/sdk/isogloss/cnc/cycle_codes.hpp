/// The codes of the canned cycles: group 09 of a Fanuc, and the codes that other plugins declare with the same kind.
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

inline constexpr std::array<std::string_view, 13> cycle_codes = {"G73", "G74", "G76", "G77", "G81", "G82", "G83",
                                                                 "G84", "G85", "G86", "G87", "G88", "G89"};

/// The unit that a CannedCycle gives to its codes; syntaxes for all canned cycles find the codes by it.
inline constexpr std::string_view cycle_kind = "canned-cycle";

/// The kind of a code that repeats the canned cycle of its block, or the one in force, and has its words before it.
inline constexpr std::string_view hole_pattern_kind = "hole-pattern";

/// A Call with the words of all canned cycles of a chain: rows first for the codes in `before`, then for those of group
/// 09, then for each further code that a CannedCycle of any plugin declares.
class CycleCalls : public Call {
 public:
  CycleCalls(std::string_view words, Access access, std::initializer_list<std::string_view> before = {})
      : Call(and_cycle_codes(before), words, access) {
    const std::string pattern = "Parsing.*{" + std::string(cycle_kind) + "}";
    const MatchedFields codes(pattern, access, IG_CODE);
    const auto of_words = static_cast<Access>(access & ~static_cast<std::uint32_t>(wake));
    std::vector<MatchedFields> columns;
    for (const char letter : letters()) columns.emplace_back(pattern + '.' + letter, of_words);
    for (std::size_t i = 0; i < codes.size(); ++i) {
      const ig_field* const known = this->codes() + code_count();
      if (std::find(this->codes(), known, codes.id(i)) != known) continue;
      std::vector<ig_field> row;
      for (std::size_t at = 0; at < columns.size(); ++at)
        row.push_back(word_of(codes.path(i), letters()[at], columns[at]));
      add_row(word_name(codes.path(i)), codes.id(i), row);
    }
  }

 private:
  static std::vector<std::string_view> and_cycle_codes(std::initializer_list<std::string_view> before) {
    std::vector<std::string_view> all = before;
    all.insert(all.end(), cycle_codes.begin(), cycle_codes.end());
    return all;
  }
  static ig_field word_of(std::string_view code, char letter, const MatchedFields& column) {
    const std::string path = std::string(code) + '.' + letter;
    for (std::size_t i = 0; i < column.size(); ++i)
      if (column.path(i) == path) return column.id(i);
    return IG_NO_FIELD;
  }
};

}  // namespace ig::cnc
