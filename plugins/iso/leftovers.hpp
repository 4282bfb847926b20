/// What is left of a block: words that nobody took, codes that nobody answered.
#pragma once

#include <optional>

#include <isogloss/sdk.hpp>

namespace iso {

inline std::optional<ig_leftover> leftover(const ig::Block& b, std::uint32_t index) {
  ig_leftover out{};
  if (b.host()->leftover(b.raw(), index, &out) == 0) return std::nullopt;
  return out;
}

/// True when the block holds the code and no syntax before this one took it; Block::take() cannot tell, since a code
/// may have several answers.
inline bool is_unanswered(const ig::Block& b, ig_field code) {
  for (std::uint32_t i = 0; const auto left = leftover(b, i); ++i)
    if (left->kind == IG_LEFT_CODE && left->field == code) return true;
  return false;
}

}  // namespace iso
