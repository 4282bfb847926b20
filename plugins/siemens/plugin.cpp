// The entry of the Siemens plugin: the language of SINUMERIK 840D sl and 828D, as far as plugin iso does not have it.
// Every syntax and dependency registers itself, with its diagnostics, at the end of its own file.
#include <isogloss/sdk.hpp>

ISOGLOSS_PLUGIN("siemens", "1.0.0", "Isogloss")
