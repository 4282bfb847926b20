// The Heidenhain plugin's entry: Klartext programs of TNC 426/430, iTNC 530 and TNC 640.
#include "klartext_diagnostics.hpp"

ISOGLOSS_PLUGIN("heidenhain", "1.0.0", "Isogloss", heidenhain::klartext_diagnostics)
