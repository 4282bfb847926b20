// The entry of the Heidenhain plugin: Klartext programs of TNC 426/430, iTNC 530 and TNC 640. Every syntax and
// dependency registers itself, with its diagnostics, at the end of its own file.
#include <isogloss/sdk.hpp>

ISOGLOSS_PLUGIN("heidenhain", "1.0.0", "Isogloss")
