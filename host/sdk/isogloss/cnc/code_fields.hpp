/// The fields of the codes that a chain knows, by letter and number, for scanners that read a code as a value.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "isogloss/cnc/scan.hpp"
#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// The name of a code, such as G04 and G54.1, from ten times its number.
class CodeName {
 public:
  CodeName() = default;
  CodeName(char letter, std::size_t tenths) {
    text_[size_++] = letter;
    if (tenths < 100) text_[size_++] = '0';
    char* last = std::to_chars(text_.data() + size_, text_.data() + text_.size(), tenths / 10).ptr;
    if (tenths % 10 != 0) {
      *last++ = '.';
      *last++ = static_cast<char>('0' + tenths % 10);
    }
    size_ = static_cast<std::size_t>(last - text_.data());
  }
  std::string_view text() const { return {text_.data(), size_}; }

 private:
  std::array<char, 16> text_{};
  std::size_t size_ = 0;
};

class CodeFields {
 public:
  /// Ten times the number, for 0 to 9999 with at most one decimal; nothing for other numbers, which are not codes.
  static std::optional<std::size_t> index_of(double number) {
    const double tenths = std::round(number * 10);
    if (!(tenths >= 0 && tenths <= 99'990) || std::abs(number * 10 - tenths) > 1e-6) return std::nullopt;
    return static_cast<std::size_t>(tenths);
  }

  CodeFields() {
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      std::string_view name = fields_.path(i);  // Parsing.Flags.G54.1, Parsing.G81
      for (const std::string_view prefix : {"Parsing.Flags.", "Parsing."})
        if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
      if (name.size() < 2 || (name[0] != 'G' && name[0] != 'M')) continue;
      const ig::Decimal d = ig::read_decimal(name, 1);
      const auto index = d.ok && d.end == name.size() && d.decimals <= 1 ? index_of(d.value) : std::nullopt;
      if (!index) continue;
      std::vector<ig_field>& row = table_[name[0] == 'G' ? 0 : 1];
      if (row.size() <= *index) row.resize(*index + 1, IG_NO_FIELD);
      row[*index] = fields_.id(i);
    }
  }

  bool knows(std::string_view code) const {
    const ig::Decimal d = ig::read_decimal(code, 1);
    const auto index = d.ok ? index_of(d.value) : std::nullopt;
    const std::vector<ig_field>& row = table_[code[0] == 'G' ? 0 : 1];
    return index && *index < row.size() && row[*index] != IG_NO_FIELD;
  }

  /// Puts the code into the block at these columns; a code that no syntax knows becomes a leftover with its name.
  void set(ig::Block& b, char letter, std::size_t index, std::size_t begin, std::size_t end) const {
    const std::vector<ig_field>& row = table_[letter == 'G' ? 0 : 1];
    if (index < row.size() && row[index] != IG_NO_FIELD) {
      const ig_word word{row[index], column(begin), column(end), ig_value{}, 0, 0};
      b.set_word(word);
      return;
    }
    leave(b, IG_LEFT_UNKNOWN, CodeName(letter, index).text(), begin, end);
  }

 private:
  ig::Fields fields_{"codes", "Parsing.Flags.* Parsing.*", ig::write, "The codes that syntaxes of this chain know.",
                     IG_CODE};
  std::array<std::vector<ig_field>, 2> table_;  // of G and M
};

}  // namespace ig::cnc
