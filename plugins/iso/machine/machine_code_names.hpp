/// Names of rows of MachineCodes: codes, cycles, programs, and families of them.
#pragma once

#include <string>
#include <string_view>

#include <isogloss/cnc/scan.hpp>

namespace iso {

using namespace ig::cnc;

inline constexpr std::string_view klartext_cycle = "CYCL DEF ", klartext_probing = "TCH PROBE ";

/// The words before the number of a Klartext cycle, with the blank behind them; empty for other names.
inline std::string_view klartext_words(std::string_view name) {
  for (const std::string_view words : {klartext_cycle, klartext_probing})
    if (name.starts_with(words)) return words;
  return {};
}

/// Capital letters, one blank between two words, and codes as scanners name them: M8 is M08, M8.0 too, and G054.1 is
/// G54.1; a cycle's number has no leading zeros, and FN 19 no blank.
inline std::string canonical(std::string_view written) {
  std::string out;
  for (const char c : trim(written)) {
    if (!is_blank(c))
      out += to_upper(c);
    else if (!out.ends_with(' '))
      out += ' ';
  }
  const bool is_family = out.ends_with('*');
  const bool is_code = out.size() > 1 && (out[0] == 'G' || out[0] == 'M') && is_digit(out[1]);
  if (is_code && out.ends_with(".0")) out.resize(out.size() - 2);
  if (is_code && out.ends_with('.')) out.pop_back();
  while (is_code && out[1] == '0' && out.size() > 2 && is_digit(out[2])) out.erase(1, 1);
  if (is_code && !is_family && skip_digits(out, 1) == 2) out.insert(1, 1, '0');
  if (out.starts_with("FN ") && out.size() > 3 && is_digit(out[3])) out.erase(2, 1);
  const std::size_t number = klartext_words(out).size();
  while (number > 0 && out.size() > number + 1 && out[number] == '0') out.erase(number, 1);
  while (out.size() > 2 && out[0] == 'O' && out[1] == '0' && is_digit(out[2])) out.erase(1, 1);
  return out;
}

/// G or M with a number that may have one decimal.
inline bool is_code(std::string_view name) {
  if (name.size() < 2 || (name[0] != 'G' && name[0] != 'M')) return false;
  const std::size_t end = skip_digits(name, 1);
  return end > 1 && (end == name.size() || (name[end] == '.' && end + 2 == name.size() && is_digit(name[end + 1])));
}

/// A cycle, or what may call a program: two letters or more, or L and a number.
inline bool is_found_by_name(std::string_view name) {
  if (const std::size_t number = klartext_words(name).size(); number > 0)
    return name.size() > number && skip_digits(name, number) == name.size();
  const auto is_part = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
  if (name.size() < 2 || is_digit(name[0]) || skip_while(name, 0, is_part) != name.size()) return false;
  return !is_digit(name[1]) || ((name[0] == 'L' || name[0] == 'O') && skip_digits(name, 1) == name.size());
}

/// The beginning that the names of a family have in common; empty where the name is none of a family.
inline std::string_view beginning_of_family(std::string_view name) {
  return name.ends_with('*') ? name.substr(0, name.size() - 1) : std::string_view{};
}

/// G and M with digits or none: a family of codes, to which no program belongs.
inline bool begins_codes(std::string_view beginning) {
  return (beginning[0] == 'G' || beginning[0] == 'M') && skip_digits(beginning, 1) == beginning.size();
}

/// CYCLE9*, L9*, M2*, CYCL DEF 3*: the beginning of what a name may be.
inline bool is_family(std::string_view name) {
  const std::string_view beginning = beginning_of_family(name);
  if (beginning.empty()) return false;
  if (const std::size_t number = klartext_words(name).size(); number > 0)
    return skip_digits(beginning, number) == beginning.size();
  const auto is_part = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
  return !is_digit(name[0]) && skip_while(beginning, 0, is_part) == beginning.size();
}

inline bool names_codes(std::string_view name) {
  return is_code(name) || (is_family(name) && begins_codes(beginning_of_family(name)));
}

/// The name as families compare it: M08 is M8.
inline std::string without_zeros(std::string name) {
  if (is_code(name) && name[1] == '0' && name.size() > 2 && is_digit(name[2])) name.erase(1, 1);
  return name;
}

}  // namespace iso
