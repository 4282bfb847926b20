/// Codes of one modal group exclude each other.
#pragma once

#include <isogloss/sdk.hpp>

#include <optional>

namespace iso {

/// The code of the group that counts: the last one in the block, as on Fanuc. More than one is worth a warning.
inline std::optional<std::size_t> take_modal(ig::Block& b, const ig::Codes& group) {
  std::uint32_t found = 0;
  const std::optional<std::size_t> last = b.take(group, &found);
  if (found > 1) b.report(ig::diag("ISO-0201"), ig::Where::word(group.id(*last)), b.text(group.name(*last)));
  return last;
}

}  // namespace iso
