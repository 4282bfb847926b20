/// The characters of an expression; capitals and small letters are the same.
#pragma once

#include <cstddef>
#include <string_view>

namespace fanuc::detail {

constexpr bool is_space(char c) { return c == ' ' || c == '\t'; }
constexpr bool is_number_start(char c) { return (c >= '0' && c <= '9') || c == '.'; }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
constexpr bool is_name(char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; }

constexpr bool equals(std::string_view text, std::string_view capitals) {
  if (text.size() != capitals.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (upper(text[i]) != capitals[i]) return false;
  return true;
}

}  // namespace fanuc::detail
