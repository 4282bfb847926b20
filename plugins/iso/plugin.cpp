// The ISO plugin's entry: codes and cycles as the ISO 6983 family of controls shares them. Every syntax and dependency
// registers itself at the end of its own file.
#include <algorithm>

#include "recognition_diagnostics.hpp"

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
    joined(diagnostics, rotary_diagnostics, tilt_diagnostics, tool_center_diagnostics, cycle_diagnostics,
           subprogram_diagnostics, radius_compensation_diagnostics, pattern_diagnostics, rotary_offset_diagnostics,
           pocket_diagnostics, corner_diagnostics, recognition_diagnostics);

// Each part must stand where its codes are looked for.
static_assert(all_diagnostics[tool_center_diag("ISO-0441")].code == std::string_view("ISO-0441"));
static_assert(all_diagnostics[cycle_diag("ISO-0354")].code == std::string_view("ISO-0354"));
static_assert(all_diagnostics[subprogram_diag("ISO-0494")].code == std::string_view("ISO-0494"));
static_assert(all_diagnostics[radius_diag("ISO-0461")].code == std::string_view("ISO-0461"));
static_assert(all_diagnostics[pattern_diag("ISO-0355")].code == std::string_view("ISO-0355"));
static_assert(all_diagnostics[rotary_offset_diag("ISO-0405")].code == std::string_view("ISO-0405"));
static_assert(all_diagnostics[pocket_diag("ISO-0501")].code == std::string_view("ISO-0501"));
static_assert(all_diagnostics[corner_diag("ISO-0478")].code == std::string_view("ISO-0478"));
static_assert(all_diagnostics[recognition_diag("ISO-0540")].code == std::string_view("ISO-0540"));

}  // namespace
}  // namespace iso

ISOGLOSS_PLUGIN("iso", "1.0.0", "Isogloss", iso::all_diagnostics)
