/// The codes that own words, as the chain declares them: for each code Parsing.G81 its words Parsing.G81.X … and the
/// words of the block with the same addresses.
#pragma once

#include <algorithm>
#include <bit>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <isogloss/sdk.hpp>

namespace iso {

/// The words of one code, or of the block itself.
struct WordRow {
  ig_field code = IG_NO_FIELD;
  std::string_view name;  ///< of the code, "G81"
  std::vector<ig_field> words;
  std::vector<char> letters;
  std::vector<std::string_view> units;
  static constexpr std::size_t most = 32, usual = 8;

  ig_field word(char letter) const {
    const auto it = std::find(letters.begin(), letters.end(), letter);
    return it == letters.end() ? IG_NO_FIELD : words[static_cast<std::size_t>(it - letters.begin())];
  }
  void add(char letter, ig_field word_field, std::string_view unit) {
    if (words.size() == most) return;
    if (words.empty()) {
      letters.reserve(usual);
      words.reserve(usual);
      units.reserve(usual);
    }
    letters.push_back(letter);
    words.push_back(word_field);
    units.push_back(unit);
  }
};

/// One row for each code that owns words, in the order of `codes`; codes without words get no row.
inline std::vector<WordRow> rows_of(const ig::Fields& codes, const ig::Fields& words) {
  std::vector<WordRow> rows(codes.size());
  std::unordered_map<std::string_view, std::size_t> row_of;
  for (std::size_t c = 0; c < codes.size(); ++c) {
    const std::string_view path = codes.path(c);
    rows[c].code = codes.id(c);
    rows[c].name = path.substr(path.rfind('.') + 1);
    row_of.emplace(path, c);
  }
  for (std::size_t w = 0; w < words.size(); ++w) {
    const std::string_view word = words.path(w);  // Parsing.G81.X
    const auto owner = row_of.find(word.substr(0, word.size() - 2));
    if (owner != row_of.end()) rows[owner->second].add(word.back(), words.id(w), words.unit(w));
  }
  std::erase_if(rows, [](const WordRow& row) { return row.words.empty(); });
  return rows;
}

/// The words that belong to the block and to no code.
inline WordRow row_of_block(const ig::Fields& words) {
  WordRow row;
  for (std::size_t w = 0; w < words.size(); ++w) row.add(words.path(w).back(), words.id(w), words.unit(w));
  return row;
}

}  // namespace iso
