// The Siemens plugin's entry: the language of SINUMERIK 840D sl and 828D, and what of it plugin iso has not.
#include "siemens_diagnostics.hpp"

ISOGLOSS_PLUGIN("siemens", "1.0.0", "Isogloss", siemens::diagnostics)
