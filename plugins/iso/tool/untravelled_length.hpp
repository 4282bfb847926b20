/// A change of the tool length that no move has travelled yet: under G91 the next move along Z does, on controls where
/// a new length is a move.
#pragma once

#include <isogloss/sdk.hpp>

namespace iso {

/// In mm along Z of the machine; absent where nothing is pending.
inline ig::Field<double> untravelled_length(ig::Access access) {
  return {"ToolHeightCompensation.Untravelled_mm",
          access,
          {ig::Life::modal, "mm", "Change of the length that the next Z under G91 moves by."}};
}

}  // namespace iso
