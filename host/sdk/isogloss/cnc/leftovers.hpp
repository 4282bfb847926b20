/// The leftovers of a block: words that no syntax has taken, and codes that no syntax has answered.
#pragma once

#include <optional>
#include <string>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// One leftover. `begin` and `end` are byte columns, 0-based, end exclusive. The name is a copy: the host's own text is
/// valid only until the first leftover is asked for again.
struct Leftover {
  ig_leftover_kind kind;
  ig_field field;
  std::uint32_t begin, end;
  std::string name;
};

/// Leftover number `index`, from 0; nothing past the last one.
inline std::optional<Leftover> leftover(const Block& b, std::uint32_t index) {
  ig_leftover left{};
  if (b.host()->leftover(b.raw(), index, &left) == 0) return std::nullopt;
  return Leftover{left.kind, left.field, left.begin, left.end, std::string(to_view(left.name))};
}

/// True when the block holds the code and no earlier syntax has answered it. Block::take() cannot tell, since several
/// syntaxes may answer one code.
inline bool is_unanswered(const Block& b, ig_field code) {
  ig_value value;
  if (!b.get(code, value)) return false;
  for (std::uint32_t i = 0; const auto left = leftover(b, i); ++i)
    if (left->kind == IG_LEFT_CODE && left->field == code) return true;
  return false;
}

}  // namespace ig::cnc
