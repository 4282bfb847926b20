/// The codes that call macros of the machine's builder: their names, and the names of the files.
#pragma once

#include <string>
#include <string_view>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

#include "macro/macro_store.hpp"

namespace syntec {

/// G0 becomes G00, G200.0 becomes G200.
inline std::string macro_code_name(char letter, std::string_view number) {
  while (number.size() > 1 && number.front() == '0' && ig::cnc::is_digit(number[1])) number.remove_prefix(1);
  if (number.ends_with(".0")) number.remove_suffix(2);
  if (number.ends_with('.')) number.remove_suffix(1);
  return std::string(1, letter) + (ig::cnc::skip_digits(number, 0) < 2 ? "0" : "") + std::string(number);
}

/// The name of the macro's file: G0200, G200001 for G200.1, M0123.
inline std::string macro_code_file(std::string_view name) {
  const std::size_t point = std::min(name.find('.'), name.size());
  std::string digits(name.substr(1, point - 1));
  const std::size_t width = point < name.size() ? 3 : 4;
  if (digits.size() < width) digits.insert(0, width - digits.size(), '0');
  if (point < name.size()) {
    const std::string_view decimals = name.substr(point + 1);
    if (decimals.size() < 3) digits.append(3 - decimals.size(), '0');
    digits.append(decimals);
  }
  return name.front() + digits;
}

/// In a macro that an M or a T code has called, M and T codes have their own meaning; in one of a G code, the G codes
/// that parameters assign to macros have. G200 to G999 always call.
inline bool calls_macro(std::string_view name, Caller running) {
  const bool is_extension = name[0] == 'G' && ig::cnc::skip_digits(name, 1) == 4 && name[1] >= '2';
  if (is_extension || running == Caller::program) return true;
  return name[0] == 'G' ? running != Caller::g_code : running == Caller::g_code;
}

}  // namespace syntec
