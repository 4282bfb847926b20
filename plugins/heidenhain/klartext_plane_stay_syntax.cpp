// PLANE … STAY: nothing moves, and from here on coordinates count in the plane as the rotary axes stand, wherever the
// program positions them: the frame follows the axes as after TURN.
#include <isogloss/sdk.hpp>

namespace heidenhain {
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

  ig::Status build(ig::Block& b) {
    b.set(aligned_, true);
    return ig::Status::changed;
  }
};

const ig::Register<KlartextPlaneStay> registered;

}  // namespace
}  // namespace heidenhain
