/// Cells of a table that is written.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <isogloss/sdk.hpp>

#include "tables/table_head.hpp"

namespace heidenhain {

/// The widths of columns: a row's number; a sign, nine digits, a point, as many decimals, and a blank.
inline constexpr std::size_t width_of_row_number = 8, width_of_value = 21;

/// The text, and blanks up to `width` characters of UTF-8.
inline std::string padded(std::string_view text, std::size_t width) {
  std::string out(text);
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++characters) i = after_characters(text, i, 1);
  out.append(width - std::min(width, characters), ' ');
  return out;
}

/// "+98.125": a sign, and no zeros at the end.
inline std::string number_text(double value) {
  constexpr int most_decimals = 9;
  std::array<char, 40> digits{};
  char* const end = digits.data() + digits.size();
  const auto last = std::to_chars(digits.data(), end, value, std::chars_format::fixed, most_decimals).ptr;
  std::string text(digits.data(), last);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text.starts_with('-') ? text : "+" + text;
}

/// The number of a cell of ours; nothing where it holds none, or one that no column takes.
inline std::optional<double> number_of_cell(std::string_view text) {
  constexpr double largest = 1e8;
  const ig::Decimal value = ig::read_decimal(text, 0);
  const bool is_number = value.ok && value.end == text.size() && std::abs(value.value) <= largest;
  return is_number ? std::optional(value.value) : std::nullopt;
}

/// A number of ours in the column of a table; `per_unit` is what one unit of the table is in ours. Names a text that is
/// no number.
inline std::string written_cell(ig::Export& out, const char* dependency, std::uint32_t row, std::string_view column,
                                double per_unit) {
  const std::string_view text = out.cell(dependency, row, column);
  const std::optional<double> value = number_of_cell(text);
  if (!value && !text.empty()) out.unused("column " + std::string(column), "it holds no number");
  return padded(value ? number_text(*value / per_unit) : "", width_of_value);
}

}  // namespace heidenhain
