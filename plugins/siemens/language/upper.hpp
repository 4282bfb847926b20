/// Names in capital letters, as they are compared.
#pragma once

#include <string>
#include <string_view>

#include <isogloss/cnc/scan.hpp>

namespace siemens {

using namespace ig::cnc;

constexpr bool is_name_start(char c) { return is_letter(c) || c == '_'; }
constexpr bool is_name_part(char c) { return is_letter(c) || is_digit(c) || c == '_'; }
constexpr std::size_t skip_name(std::string_view text, std::size_t position) {
  return skip_while(text, position, is_name_part);
}
/// The same, but `position` where the name has more than 200 characters; the control has 32. For scanners, which are
/// asked again behind each part of such a text: reading all of it each time would take seconds.
constexpr std::size_t skip_short_name(std::string_view text, std::size_t position) {
  constexpr std::size_t longest = 200;
  const std::size_t end = skip_name(text.substr(0, position + longest + 1), position);
  return end - position > longest ? position : end;
}
inline std::string upper(std::string_view name) {
  std::string out(name);
  for (char& c : out) c = to_upper(c);
  return out;
}

}  // namespace siemens
