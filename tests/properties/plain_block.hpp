/// What a block of plain ISO words says, by the manuals and not by what the product declares.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "running.hpp"

namespace isogloss::properties {

struct PlainWord {
  char address = 0;
  double value = 0;
  std::string text;
};

using Codes = std::set<double>;

struct PlainBlock {
  std::uint32_t line = 0;
  std::vector<PlainWord> words;
  Codes codes;  ///< G codes

  bool has(char address) const { return has_any_of({&address, 1}); }
  bool has_any_of(std::string_view addresses) const;
  bool has_code(const Codes& wanted) const;
  bool is_cycle() const;
  bool is_arc() const { return has_code({2, 3}); }
  const PlainWord* word(char address) const;
  /// In the form in which the words were written.
  std::string text() const;
};

/// The block, where it has nothing but words and comments, whose meaning is known here in this dialect; nothing for
/// others. Comments are left out, and so are codes of units.
std::optional<PlainBlock> plain_block(const Case& program, const std::string& text, const Block& block);

/// A decimal with a point, which reads back as the number.
std::string decimal(double value);

}  // namespace isogloss::properties
