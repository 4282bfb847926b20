// The kinematics plugin's entry: what the rotary axes of a machine do to tool and workpiece.
#include <isogloss/sdk.hpp>

ISOGLOSS_PLUGIN("kinematics", "1.0.0", "Isogloss", std::span<const ig_diagnostic_decl>{})
