#include "new/names.hpp"

#include <algorithm>

namespace isogloss::cli {

namespace {

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_ascii_letter(char c) { return is_capital(c) || (c >= 'a' && c <= 'z'); }
bool is_ascii_digit(char c) { return c >= '0' && c <= '9'; }
char capital(char c) { return is_ascii_letter(c) && !is_capital(c) ? static_cast<char>(c - 'a' + 'A') : c; }
char small(char c) { return is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c; }

/// As a namespace or as a target of CMake, these would not build.
constexpr std::string_view reserved =
    " alignas alignof and asm auto bitand bitor bool break case catch char class compl concept const consteval "
    "constexpr"
    " constinit continue decltype default delete do double else enum explicit export extern false float for friend goto"
    " if inline int long mutable namespace new noexcept not nullptr operator or private protected public register"
    " requires return short signed sizeof static struct switch template this throw true try typedef typeid typename"
    " union unsigned using virtual void volatile wchar_t while xor std ig main all clean depend edit_cache help install"
    " package rebuild_cache test isogloss ";

}  // namespace

bool is_plugin_name(std::string_view name) {
  if (name.empty() || name.size() > 40 || !is_ascii_letter(name.front()) || name.back() == '-') return false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool is_hyphen = name[i] == '-' && name[i - 1] != '-';
    if (!is_ascii_letter(name[i]) && !is_ascii_digit(name[i]) && !is_hyphen) return false;
  }
  std::string word(name);
  std::transform(word.begin(), word.end(), word.begin(), small);
  return reserved.find(" " + word + " ") == std::string_view::npos;
}

std::string type_name_of(std::string_view name) {
  std::string out;
  bool begins_part = true;
  for (const char c : name) {
    if (c != '-') out += begins_part ? capital(c) : c;
    begins_part = c == '-';
  }
  return out;
}

std::string snake_case(std::string_view id) {
  std::string out;
  for (std::size_t i = 0; i < id.size(); ++i) {
    if (is_capital(id[i]) && i > 0 && !is_capital(id[i - 1])) out += '_';
    out += small(id[i]);
  }
  return out;
}

std::string lower_case(std::string_view name) {
  std::string out(name);
  std::transform(out.begin(), out.end(), out.begin(), small);
  return out;
}

std::string upper_case(std::string_view name) {
  std::string out(name);
  std::transform(out.begin(), out.end(), out.begin(), capital);
  return out;
}

std::string identifier(std::string_view name) {
  std::string out(name);
  std::replace(out.begin(), out.end(), '-', '_');
  return out;
}

std::string prefix_of(std::string_view name) {
  std::string out;
  for (const char c : name)
    if (is_ascii_letter(c) && out.size() < 4) out += capital(c);
  return out;
}

bool is_prefix(std::string_view prefix) {
  return prefix.size() >= 2 && prefix.size() <= 8 && std::all_of(prefix.begin(), prefix.end(), is_capital);
}

std::string escaped_literal(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\' || c == '"') out += '\\';
    out += c;
  }
  return out;
}

bool is_one_line(std::string_view text) {
  return std::none_of(text.begin(), text.end(),
                      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

std::pair<std::string, std::string> switch_codes(std::string_view codes) {
  const std::size_t comma = codes.find(',');
  if (comma == std::string_view::npos) return {};
  std::pair<std::string, std::string> out;
  const auto read = [](std::string_view code) -> std::string {
    if (code.size() < 2 || code.size() > 5 || capital(code.front()) != 'M') return {};
    const std::string_view digits = code.substr(1);
    if (!std::all_of(digits.begin(), digits.end(), is_ascii_digit)) return {};
    return (digits.size() == 1 ? "M0" : "M") + std::string(digits);
  };
  out = {read(codes.substr(0, comma)), read(codes.substr(comma + 1))};
  return out.first.empty() || out.second.empty() || out.first == out.second ? std::pair<std::string, std::string>{}
                                                                            : out;
}

std::string cycle_code(std::string_view code) {
  if (code.size() < 2 || code.size() > 4 || capital(code.front()) != 'G') return {};
  const std::string_view digits = code.substr(1);
  if (!std::all_of(digits.begin(), digits.end(), is_ascii_digit)) return {};
  return (digits.size() == 1 ? "G0" : "G") + std::string(digits);
}

}  // namespace isogloss::cli
