/// What a call says of its frame in the tag: bits that the syntaxes of several plugins agree on.
#pragma once

#include <cstdint>

namespace ig::cnc {

/// The call names the block at which the program begins: the program number stands before it, and is not run.
inline constexpr std::uint64_t begins_inside = std::uint64_t{1} << 61;

}  // namespace ig::cnc
