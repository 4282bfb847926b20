/// The index of a diagnostic in a plugin's table, computed when it is compiled.
#pragma once

#include <array>
#include <string_view>

#include <isogloss/sdk.hpp>

namespace iso {

/// The index of a code in one part of the table, which begins at `first`; an unknown code does not compile.
template <std::size_t Size>
consteval std::uint32_t index_of(const std::array<ig_diagnostic_decl, Size>& part, std::string_view code,
                                 std::size_t first) {
  for (std::size_t i = 0; i < Size; ++i)
    if (code == part[i].code) return static_cast<std::uint32_t>(first + i);
  throw "no such diagnostic";
}

}  // namespace iso
