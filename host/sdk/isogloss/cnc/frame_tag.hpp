/// Bits of a call's tag (ig_go::tag) that tell something about the called frame, for syntaxes of several plugins.
#pragma once

#include <cstdint>

namespace ig::cnc {

/// Set where the call names the block at which the called program begins: the program number stands before that block
/// and does not run.
inline constexpr std::uint64_t begins_inside = std::uint64_t{1} << 61;

}  // namespace ig::cnc
