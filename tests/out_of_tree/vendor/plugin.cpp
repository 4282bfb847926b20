#include <isogloss/sdk.hpp>

ISOGLOSS_PLUGIN("acme", "1.0.0", "Acme Clamping")
