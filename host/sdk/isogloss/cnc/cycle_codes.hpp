/// The canned cycles of group 09.
#pragma once

#include <array>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace ig::cnc {

inline constexpr std::array<std::string_view, 13> cycle_codes = {"G73", "G74", "G76", "G77", "G81", "G82", "G83",
                                                                 "G84", "G85", "G86", "G87", "G88", "G89"};

/// Some other codes, and then the cycles: rows of one Call.
inline std::vector<std::string_view> and_cycle_codes(std::initializer_list<std::string_view> before) {
  std::vector<std::string_view> codes = before;
  codes.insert(codes.end(), cycle_codes.begin(), cycle_codes.end());
  return codes;
}

}  // namespace ig::cnc
