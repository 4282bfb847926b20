// The Siemens plugin's entry: the language of SINUMERIK 840D sl and 828D, and what of it plugin iso has not.
// Every syntax and dependency registers itself, with its diagnostics, at the end of its own file.
#include <isogloss/sdk.hpp>

ISOGLOSS_PLUGIN("siemens", "1.0.0", "Isogloss")
