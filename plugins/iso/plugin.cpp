// The ISO plugin's entry: codes and cycles as the ISO 6983 family of controls shares them. Every syntax and dependency
// registers itself at the end of its own file.
#include <algorithm>

#include "cycle_diagnostics.hpp"
#include "subprogram_diagnostics.hpp"

namespace iso {
namespace {

template <std::size_t... Sizes>
constexpr auto joined(const std::array<ig_diagnostic_decl, Sizes>&... parts) {
  std::array<ig_diagnostic_decl, (Sizes + ...)> all{};
  auto* to = all.begin();
  ((to = std::copy(parts.begin(), parts.end(), to)), ...);
  return all;
}

constexpr auto all_diagnostics =
    joined(diagnostics, rotary_diagnostics, tilt_diagnostics, tool_center_diagnostics, cycle_diagnostics, subprogram_diagnostics);

}  // namespace
}  // namespace iso

ISOGLOSS_PLUGIN("iso", "1.0.0", "Isogloss", iso::all_diagnostics)
