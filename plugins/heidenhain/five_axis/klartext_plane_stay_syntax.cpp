// PLANE … STAY: nothing moves. From here on coordinates are in the plane as the present rotary axes have it, wherever
// the program positions them later: the frame follows the axes as after TURN. The tool length lies along the tool as
// the axes hold it now, since a program that finds them in place moves none of them.
#include <isogloss/cnc/tool_kinematics.hpp>

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextPlaneStay {
  static constexpr auto spec =
      ig::syntax("KlartextPlaneStaySyntax", "PLANE … STAY: the frame follows the rotary axes from here on.")
          .after("KlartextPlaneSyntax", "IsoG68p2TiltSyntax", "G53p1RotaryPositionSyntax")
          .before("PivotTransformationSyntax");

  ig::In<bool> stay_{"KlartextPlane.IsStaying",
                     ig::wake,
                     {ig::Life::block, "", "PLANE ... STAY: the program positions the axes itself."}};
  ig::Out<bool> aligned_{"TiltTransform.IsAligned",
                         {ig::Life::modal, "", "G53.1 or G53.6 has put the tool upright on the plane."}};

  std::array<ig::In<double>, 3> angles_{ig::In<double>{"MachineCoordinate.A"}, ig::In<double>{"MachineCoordinate.B"},
                                        ig::In<double>{"MachineCoordinate.C"}};
  ig::Xyz orientation_{"ToolOrientation", ig::write};
  ToolKinematics machine_;

  ig::Status build(ig::Block& b) {
    if (!b.has(stay_)) return ig::Status::unchanged;
    b.set(aligned_, true);
    if (!machine_) return ig::Status::changed;
    Angles angles{};
    for (std::size_t i = 0; i < 3; ++i) angles[i] = b.get_or(angles_[i], 0.0);
    if (const auto tool = machine_.tool_axis(angles)) b.set(orientation_, *tool);
    return ig::Status::changed;
  }
};

const ig::Register<KlartextPlaneStay> klartext_plane_stay_syntax;

}  // namespace
}  // namespace heidenhain
