// The Syntec plugin's entry: what a Syntec has beyond the ISO and Fanuc plugins.
#include "syntec_diagnostics.hpp"

ISOGLOSS_PLUGIN("syntec", "1.0.0", "Isogloss", syntec::diagnostics)
