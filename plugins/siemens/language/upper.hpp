/// Names in capital letters, as they are compared.
#pragma once

#include <string>
#include <string_view>

#include <isogloss/cnc/scan.hpp>

namespace siemens {

constexpr bool is_name_start(char c) { return is_letter(c) || c == '_'; }
constexpr bool is_name_part(char c) { return is_letter(c) || is_digit(c) || c == '_'; }
constexpr std::size_t skip_name(std::string_view text, std::size_t position) {
  return skip_while(text, position, is_name_part);
}
inline std::string upper(std::string_view name) {
  std::string out(name);
  for (char& c : out) c = ig::cnc::to_upper(c);
  return out;
}

}  // namespace siemens
