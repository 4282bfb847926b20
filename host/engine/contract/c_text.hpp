/// Texts on their way over the boundary.
#pragma once

#include <string_view>

#include "isogloss.h"

namespace isogloss {

inline ig_text to_text(std::string_view s) { return {s.data(), s.size()}; }
inline std::string_view to_view(ig_text t) { return {t.data, t.size}; }

}  // namespace isogloss
