/// What the descriptors of syntaxes, dependencies and importers share.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "isogloss/declare.hpp"
#include "isogloss/pages.hpp"

namespace ig {

/// A list of at most 12 names of syntaxes, services or dependencies. It is a literal type, so that a spec can be a
/// constant.
struct NameList {
  std::array<const char*, 13> names{};  // the last one stays null
  std::size_t count = 0;
  constexpr void add(const char* name) {
    if (count + 1 == names.size()) throw "a list holds at most 12 names";  // does not compile: specs are constexpr
    names[count++] = name;
  }
  const char* const* data() const { return count == 0 ? nullptr : names.data(); }
};

namespace detail {

/// "drilling_cycle_syntax" for "DrillingCycleSyntax"; a run of capitals or digits stays together.
inline std::string snake_case(std::string_view id) {
  std::string out;
  for (std::size_t i = 0; i < id.size(); ++i) {
    const char c = id[i];
    const bool upper = c >= 'A' && c <= 'Z';
    const bool after_upper = i > 0 && id[i - 1] >= 'A' && id[i - 1] <= 'Z';
    if (upper && i > 0 && !after_upper) out += '_';
    out += upper ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

/// What the constructor of T declares, recorded once.
template <class T>
const Recorder& recorded_of();

}  // namespace detail
}  // namespace ig
