/// Where a tool points in the machine.
#pragma once

#include "isogloss/cnc/tool_kinematics.hpp"

namespace ig::cnc {

/// The unit vector from the tip to the holder in machine coordinates; nothing for angles that are not finite. Ask it of
/// a machine whose kinematics are known.
inline std::optional<Vec3> tool_direction(const ToolKinematics& machine, const Angles& angles) {
  const auto axis = machine.tool_axis(angles);
  const auto turned = machine.pivot(angles);
  if (!axis || !turned) return std::nullopt;
  const Mat4& m = *turned;
  return mapped(m, *axis) - Vec3{m[12], m[13], m[14]};
}

}  // namespace ig::cnc
