/// G54 to G57, G505 to G599 and G500: which settable work offset is the program's origin. The base frame of the table
/// (BASE) acts after each of them. The row of G500 is usually empty. SiemensFrameShapeSyntax handles rotation, scale
/// and mirror, SiemensRotaryWordsSyntax the rotary axes.
#include <isogloss/cnc/coordinate_offset.hpp>
#include <isogloss/cnc/work_origin.hpp>
#include <isogloss/sdk.hpp>

#include "frames/settable_frames.hpp"
#include "frames/settable_shape.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensCoordinateOffset {
  static constexpr auto spec =
      ig::syntax("SiemensCoordinateOffsetSyntax", "G54-G57, G505-G599 and G500 select the work offset.")
          .after("SiemensToolOffsetSyntax")
          .before("SiemensCycleSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0211",
                     "the table has no work offset {0}, so the previous one stays in force: add it to the table"),
      ig::diagnostic(IG_ERROR, "SIE-0390",
                     "{0} is rotated, scaled or mirrored, which is not executed: add SiemensFrameShapeSyntax to the "
                     "dialect"),
  };

  SettableFrames frames_{ig::take | ig::wake};
  ig::Out<ig::Symbol> id_{"CoordinateOffset.CoordinateId"};
  OffsetSection offset_{"CoordinateOffset"};
  ig::Transform shape_{"WorkOffsetFrame", ig::read};
  ig::Service<ig_work_offset_1> table_{"isogloss.work-offset/1", ig::Need::required, "The origins."};
  ShapeTable shapes_;
  ig::Name g500_{"G500"};

  ig::Status restart(ig::Block& b) {
    select(b, frames_.in_force(b));
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    const auto frame = frames_.changed(b);
    if (!frame) return ig::Status::unchanged;
    frames_.take(b);
    select(b, *frame);
    return ig::Status::changed;
  }

 private:
  void select(ig::Block& b, const SettableFrames::Selected& frame) const {
    const auto [id, where] = frame;
    const auto own = linear_origin(table_, b.text(id));
    if (!own && id != g500_) {
      b.report(ig::diag("SIE-0211"), where, b.text(id));
      return;
    }
    const SettableShape base = shapes_.get("BASE");
    const SettableShape shape = shapes_.get(b.text(id));
    const Mat4 turn = base.matrix();
    Mat4 executed;
    if (!b.get(shape_, executed)) executed = identity_frame;
    if (product(shape.matrix(), turn) != executed) b.report(ig::diag("SIE-0390"), where, b.text(id));
    // The base frame turns the whole shift of the settable one.
    const ig::Vec3 shift = own.value_or(ig::Vec3{}) + shape[ShapePart::fine];
    b.set(id_, id);
    offset_.set(b, (turn == identity_frame ? shift : mapped(turn, shift)) +
                       linear_origin(table_, "BASE").value_or(ig::Vec3{}) + base[ShapePart::fine]);
  }
};

const ig::Register<SiemensCoordinateOffset> siemens_coordinate_offset_syntax;

}  // namespace
}  // namespace siemens
