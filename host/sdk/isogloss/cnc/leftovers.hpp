/// What is left of a block: words that nobody took, codes that nobody answered.
#pragma once

#include <optional>
#include <string>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// One piece, with a name of its own: the host's lasts only until it is asked for the first piece again.
struct Leftover {
  ig_leftover_kind kind;
  ig_field field;
  std::uint32_t begin, end;
  std::string name;
};

inline std::optional<Leftover> leftover(const Block& b, std::uint32_t index) {
  ig_leftover left{};
  if (b.host()->leftover(b.raw(), index, &left) == 0) return std::nullopt;
  return Leftover{left.kind, left.field, left.begin, left.end, std::string(to_view(left.name))};
}

/// True when the block holds the code and no syntax before this one took it; Block::take() cannot tell, since a code
/// may have several answers.
inline bool is_unanswered(const Block& b, ig_field code) {
  ig_value value;
  if (!b.get(code, value)) return false;
  for (std::uint32_t i = 0; const auto left = leftover(b, i); ++i)
    if (left->kind == IG_LEFT_CODE && left->field == code) return true;
  return false;
}

}  // namespace ig::cnc
