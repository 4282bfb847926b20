// The Fanuc plugin's entry: what Fanuc controls have beyond the ISO plugin.
#include <isogloss/sdk.hpp>

ISOGLOSS_PLUGIN("fanuc", "1.0.0", "Isogloss", std::span<const ig_diagnostic_decl>{})
