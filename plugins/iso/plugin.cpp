// The ISO plugin's entry: codes and cycles as the ISO 6983 family of controls shares them.
// Every syntax and dependency registers itself, with its diagnostics, at the end of its own file.
#include <isogloss/sdk.hpp>

ISOGLOSS_PLUGIN("iso", "1.0.0", "Isogloss")
