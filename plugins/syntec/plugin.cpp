// The entry of the Syntec plugin: what a Syntec has beyond the ISO and Fanuc plugins. Every syntax and dependency
// registers itself, with its diagnostics, at the end of its own file.
#include <isogloss/sdk.hpp>

ISOGLOSS_PLUGIN("syntec", "1.0.0", "Isogloss")
