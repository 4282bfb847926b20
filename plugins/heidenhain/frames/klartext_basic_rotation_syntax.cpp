// The basic rotation of a preset: WorkOffsetFrame, an entry of its own on the way to machine coordinates. The tool
// length, the datum shift and the origin of the preset (HeidenhainCoordinateOffsetSyntax) come after it.
#include <charconv>

#include "frames/basic_rotation.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextBasicRotation {
  static constexpr auto spec =
      ig::syntax("KlartextBasicRotationSyntax", "The basic rotation of the preset in force.")
          .after("KlartextCycleSyntax", "KlartextPlaneFrameSyntax", "IsoG68RotationSyntax", "IsoG68p2TiltSyntax")
          .before("G53p1RotaryPositionSyntax", "ToolCenterPointSyntax", "ToolHeightOffsetSyntax",
                  "HeidenhainCoordinateOffsetSyntax");

  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "HEI-0351",
                     "preset {0} turns the tilted plane, and the tool is not square to it: program PLANE after it"),
  };

  ig::Field<double> number_{"Parsing.DATUM_PRESET", ig::read | ig::wake, {ig::Life::word, "", ""}};
  ig::In<ig::Symbol> id_{"CoordinateOffset.CoordinateId"};
  ig::Transform frame_{"WorkOffsetFrame", ig::read | ig::write};
  std::array<ig::Out<double>, 3> angles_{
      ig::Out<double>{"BasicRotation.SPA", {ig::Life::modal, "deg", "Basic rotation of the preset about X."}},
      ig::Out<double>{"BasicRotation.SPB", {ig::Life::modal, "deg", "Basic rotation of the preset about Y."}},
      ig::Out<double>{"BasicRotation.SPC", {ig::Life::modal, "deg", "Basic rotation of the preset about Z."}}};
  ig::Field<bool> aligned_{"TiltTransform.IsAligned",
                           ig::read,
                           {ig::Life::modal, "", "G53.1 or G53.6 has put the tool upright on the plane."}};
  BasicRotations table_;

  ig::Status restart(ig::Block& b) { return turn(b, table_.angles_of(b.text(b.get_or(id_, ig::Symbol{})))); }

  ig::Status build(ig::Block& b) {
    const auto number = b.get(number_);
    if (!number) return ig::Status::unchanged;
    const bool is_number = *number >= 0 && *number < 1e9 && *number == std::floor(*number);
    const ig::Status status = turn(b, is_number ? table_.angles(static_cast<std::int64_t>(*number)) : ig::Vec3{});
    if (status == ig::Status::changed && b.has(aligned_))
      b.report(ig::diag("HEI-0351"), ig::Where::word(number_.id()), *number);
    return status;
  }

 private:
  ig::Status turn(ig::Block& b, const ig::Vec3& angles) const {
    const ig::Vec3 present{b.get_or(angles_[0], 0.0), b.get_or(angles_[1], 0.0), b.get_or(angles_[2], 0.0)};
    const Mat4 m = BasicRotations::matrix(angles);
    Mat4 frame = identity_frame;
    b.get(frame_, frame);
    if (angles == present && m == frame) return ig::Status::unchanged;
    for (std::size_t i = 0; i < 3; ++i)
      if (angles == ig::Vec3{})
        b.erase(angles_[i]);
      else
        b.set(angles_[i], angles[i]);
    b.set_transform(frame_, m);
    return ig::Status::changed;
  }
};

const ig::Register<KlartextBasicRotation> klartext_basic_rotation_syntax;

}  // namespace
}  // namespace heidenhain
