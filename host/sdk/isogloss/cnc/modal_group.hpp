/// Codes of one modal group exclude each other.
#pragma once

#include "isogloss/sdk.hpp"

#include <optional>

namespace ig::cnc {

inline const Diagnostics modal_group_diagnostics{
    diagnostic(
        IG_WARNING, "ISO-0201", "this block has more than one code of a modal group: {0} is used, so remove the others",
        "Codes of one group exclude each other. The control uses the last one without an alarm, and so does this run.",
        "G90 G91 X10."),
};

/// The code of the group that counts: the last one in the block, as on Fanuc. More than one is worth a warning.
inline std::optional<std::size_t> take_modal(Block& b, const Codes& group) {
  std::uint32_t found = 0;
  const std::optional<std::size_t> last = b.take(group, &found);
  if (found > 1) b.report(diag("ISO-0201"), Where::word(group.id(*last)), b.text(group.name(*last)));
  return last;
}

}  // namespace ig::cnc
