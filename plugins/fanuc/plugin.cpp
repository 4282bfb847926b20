// The Fanuc plugin's entry: what Fanuc controls have beyond the ISO plugin.
#include "macro_diagnostics.hpp"

ISOGLOSS_PLUGIN("fanuc", "1.0.0", "Isogloss", fanuc::macro_diagnostics)
