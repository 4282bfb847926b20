// The entry of the ISO plugin: the codes and cycles that the ISO 6983 family of controls shares. Every syntax and
// dependency registers itself, with its diagnostics, at the end of its own file.
#include <isogloss/sdk.hpp>

ISOGLOSS_PLUGIN("iso", "1.0.0", "Isogloss")
