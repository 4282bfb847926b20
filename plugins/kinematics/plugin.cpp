// The entry of the kinematics plugin: the effect of the machine's rotary axes on tool and workpiece.
#include <isogloss/sdk.hpp>

ISOGLOSS_PLUGIN("kinematics", "1.0.0", "Isogloss", std::span<const ig_diagnostic_decl>{})
