// The Fanuc plugin's entry: what Fanuc controls, and those that descend from them, have beyond the ISO plugin.
#include <algorithm>

#include "brand_diagnostics.hpp"

namespace fanuc {
namespace {

constexpr auto all_diagnostics = [] {
  std::array<ig_diagnostic_decl, macro_diagnostics.size() + brand_diagnostics.size()> all{};
  std::copy(brand_diagnostics.begin(), brand_diagnostics.end(),
            std::copy(macro_diagnostics.begin(), macro_diagnostics.end(), all.begin()));
  return all;
}();

static_assert(all_diagnostics[brand_diag("FAN-0201")].code == std::string_view("FAN-0201"));

}  // namespace
}  // namespace fanuc

ISOGLOSS_PLUGIN("fanuc", "1.0.0", "Isogloss", fanuc::all_diagnostics)
