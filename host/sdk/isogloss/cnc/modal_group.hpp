/// Takes the codes of a modal group from a block: they exclude each other, and the last one is in force.
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
/// Takes all codes of the group and returns the index of the last one in the block, as on Fanuc; nothing where the
/// block holds none. Reports ISO-0201 where it holds more than one.
inline std::optional<std::size_t> take_modal(Block& b, const Codes& group) {
  std::uint32_t found = 0;
  const std::optional<std::size_t> last = b.take(group, &found);
  if (found > 1) b.report(diag("ISO-0201"), Where::word(group.id(*last)), b.text(group.name(*last)));
  return last;
}

}  // namespace ig::cnc
