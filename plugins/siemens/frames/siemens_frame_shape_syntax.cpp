/// The settable frame's rotation, scale and mirror: WorkOffsetFrame, an entry of its own on the way to machine
/// coordinates. The tool length and the shift (SiemensCoordinateOffsetSyntax) come after it, so that a rotated frame
/// turns neither.
#include <isogloss/sdk.hpp>

#include "frames/frame_shape.hpp"
#include "frames/settable_frames.hpp"
#include "frames/settable_shape.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensFrameShape {
  static constexpr auto spec =
      ig::syntax("SiemensFrameShapeSyntax", "Rotation, scale and mirror of the settable frames.")
          .after("SiemensFrameSyntax", "SiemensSwivelSyntax", "IsoG68p2TiltSyntax")
          .before("G53p1RotaryPositionSyntax", "SiemensTransformationSyntax", "SiemensToolOffsetSyntax",
                  "ToolCenterPointSyntax", "SiemensCoordinateOffsetSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0391",
                     "{0} under G41 or G42 has unequal scales, so the tool is not beside the contour: make them equal"),
      ig::diagnostic(IG_WARNING, "SIE-0392",
                     "{0} turns the swivelled plane, and the tool is not square to it: program CYCLE800 after {0}"),
  };

  SettableFrames frames_{ig::read | ig::wake};
  ig::Transform frame_{"WorkOffsetFrame", ig::read | ig::write};
  ig::Signal uneven_{"WorkOffsetFrame.~Uneven", ig::read | ig::write, ig::Life::modal};
  ig::InWhile<ig::Symbol> left_{"RadiusCompensation.Term", "G41"}, right_{"RadiusCompensation.Term", "G42"};
  ig::Signal compensation_said_{"WorkOffsetFrame.~CompensationSaid", ig::read | ig::write | ig::wake_while,
                                ig::Life::modal};
  ig::Transform programmable_{"ProgrammableFrame", ig::read}, tilt_{"TiltTransform", ig::read};
  ig::Field<bool> aligned_{"TiltTransform.IsAligned",
                           ig::read,
                           {ig::Life::modal, "", "G53.1 or G53.6 has put the tool upright on the plane."}};
  ig::Call align_{{"G53.1"}, "", ig::read};
  ShapeTable shapes_;
  PlaneInForce plane_;
  ig::Name g41_{"G41"}, g42_{"G42"};

  ig::Status restart(ig::Block& b) {
    return select(b, frames_.in_force(b).id) ? ig::Status::changed : ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    bool any = false;
    if (const auto frame = frames_.changed(b)) {
      any = select(b, frame->id);
      if (any && b.has(aligned_) && !b.find(align_)) b.report(ig::diag("SIE-0392"), frame->where, b.text(frame->id));
    }
    return report_uneven_compensation(b) || any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// The base frame acts after the frame's own shape. True where the entry changes; a frame that only shifts has none.
  bool select(ig::Block& b, ig::Symbol id) const {
    const Mat4 m = product(shapes_.get(b.text(id)).matrix(), shapes_.get("BASE").matrix());
    Mat4 present = identity_frame;
    b.get(frame_, present);
    if (m == present) return false;
    b.set_transform(frame_, m);
    if (keeps_circles(m, xy_plane) && keeps_circles(m, zx_plane))
      b.erase(uneven_);
    else
      b.raise(uneven_);
    return true;
  }

  /// Reports such a frame once each time that G41 or G42 becomes active in it.
  bool report_uneven_compensation(ig::Block& b) const {
    const bool is_wrong = b.is_raised(uneven_) && (b.is(left_, g41_) || b.is(right_, g42_)) &&
                          !keeps_circles(chained(b, {&programmable_, &tilt_, &frame_}), plane_(b));
    if (is_wrong == b.is_raised(compensation_said_)) return false;
    if (is_wrong) {
      const SettableFrames::Selected frame = frames_.selected(b);
      b.report(ig::diag("SIE-0391"), frame.where, b.text(frame.id));
      b.raise(compensation_said_);
    } else {
      b.erase(compensation_said_);
    }
    return true;
  }
};

const ig::Register<SiemensFrameShape> siemens_frame_shape_syntax;

}  // namespace
}  // namespace siemens
