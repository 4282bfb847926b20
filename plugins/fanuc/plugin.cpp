// The entry of the Fanuc plugin: what Fanuc controls and their descendants have beyond the ISO plugin. Every syntax and
// dependency registers itself, with its diagnostics, at the end of its own file.
#include <isogloss/sdk.hpp>

ISOGLOSS_PLUGIN("fanuc", "1.0.0", "Isogloss")
