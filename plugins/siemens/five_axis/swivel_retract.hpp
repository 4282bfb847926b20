/// Where the tool goes before CYCLE800 turns the rotary axes: parameter _FR. Machine coordinates, mm.
#pragma once

#include <isogloss/cnc/axis_names.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/rotary_words.hpp>
#include <isogloss/cnc/tool_kinematics.hpp>
#include <isogloss/cnc/travel_end.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

using namespace ig::cnc;

/// The fields that SiemensSwivelSyntax hands to SiemensSwivelRetractSyntax.
struct SwivelRetractFields {
  explicit SwivelRetractFields(ig::Access access)
      : target{"SiemensSwivel.Retract", access, {ig::Life::block, "mm", "_FR: where the tool goes first (machine)."}},
        z_first{"SiemensSwivel.RetractsZFirst", access, {ig::Life::block, "", "_FR 2: Z goes before X and Y."}} {}
  ig::Xyz target;
  ig::Field<bool> z_first;
};

/// A member of SiemensSwivelSyntax.
class SwivelRetract {
 public:
  /// False where the machine does not know where to retract, or _FR has no such value.
  bool prepare(ig::Block& b, double way, double distance) const {
    const ig::PartialVec3 here = b.get(machine_);
    if (!here.complete()) return false;
    auto to = way == 1 || way == 2 ? to_positions(here.value, way == 2) : along_tool(b, here.value, way, distance);
    if (!to) return false;
    b.set(fields_.target, *to);
    if (way == 2) b.set(fields_.z_first, true);
    return true;
  }

 private:
  std::optional<ig::Vec3> to_positions(const ig::Vec3& here, bool with_x_and_y) const {
    ig::Vec3 to = here;
    for (std::uint32_t axis = with_x_and_y ? 0 : 2; axis < 3; ++axis) {
      const auto position = axes_.position(axis, IG_AXIS_RETRACT);
      if (!position) return std::nullopt;
      to[axis] = *position;
    }
    return to;
  }

  /// 4: to the end of the travel. 5: by a distance.
  std::optional<ig::Vec3> along_tool(const ig::Block& b, const ig::Vec3& here, double way, double distance) const {
    const auto direction = tool_direction(b);
    if (!direction || (way != 4 && way != 5)) return std::nullopt;
    const auto rest = way == 4 ? travel_.way(here, *direction) : std::optional(distance);
    if (!rest || !(std::fabs(*rest) < 1e9)) return std::nullopt;
    return here + *rest * *direction;
  }

  std::optional<ig::Vec3> tool_direction(const ig::Block& b) const {
    ig::Vec3 out;
    out[plane_(b).tool] = 1;
    if (!kinematics_) return out;
    const Angles angles = rotary_.get(b).or_else({});
    const auto axis = kinematics_.tool_axis(angles);
    const auto turned = kinematics_.pivot(angles);
    if (!axis || !turned) return std::nullopt;
    const Mat4& m = *turned;
    return mapped(m, *axis) - ig::Vec3{m[12], m[13], m[14]};
  }

  SwivelRetractFields fields_{ig::write};
  ig::Xyz machine_{"MachineCoordinate", ig::read};
  RotaryPosition rotary_{ig::read};
  PlaneInForce plane_;
  ToolKinematics kinematics_;
  TravelEnd travel_;
  AxisNames axes_;
};

}  // namespace siemens
