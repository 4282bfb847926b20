/// Colours of tools that people with any kind of colour vision tell apart (after Okabe and Ito), on paper and on dark.
#pragma once

#include <array>
#include <string_view>

namespace isogloss::cli {

struct ToolColour {
  std::string_view on_light, on_dark;
};

inline constexpr std::array<ToolColour, 7> tool_colours{{{"#0072b2", "#56b4e9"},
                                                         {"#d55e00", "#ff9447"},
                                                         {"#009e73", "#2fc99b"},
                                                         {"#aa4499", "#f0a6cf"},
                                                         {"#b8860b", "#f0e442"},
                                                         {"#3b9bd6", "#a5dcff"},
                                                         {"#6b5b3e", "#cbb88f"}}};

}  // namespace isogloss::cli
