/// G52: a local coordinate system inside every work coordinate system. The words are the local origin itself, also
/// under G91: an axis that is named gets a new offset, one that is not keeps its own.
#include "diagnostics.hpp"

namespace iso {
namespace {

enum class CancelledBy { program_end, never };

struct IsoLocalCoordinateOffset {
  static constexpr auto spec =
      ig::syntax("IsoLocalCoordinateOffsetSyntax", "G52 local coordinate system.")
          .after("UnitModeSyntax", "ToolHeightOffsetSyntax")
          .before("IsoCoordinateOffsetSyntax", "CannedCycleResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");

  ig::Call g52_{{"G52"}, "X Y Z"};
  ig::Codes program_end_{{"M02", "M30"}, ig::read | ig::wake};
  ig::Out<double> x_{"LocalCoordinateOffset.Offset_X"};
  ig::Out<double> y_{"LocalCoordinateOffset.Offset_Y"};
  ig::Out<double> z_{"LocalCoordinateOffset.Offset_Z"};
  ig::Transform frame_{"LocalCoordinateOffset"};
  ig::Choice<CancelledBy> cancelled_by_{"cancelled-by", "program-end|never", "program-end",
                                        "Does the end of the program cancel the local system?"};

  ig::Status restart(ig::Block& b) {
    b.set_translation(frame_, offset(b));
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    if (const auto words = b.take(g52_)) {
      const ig::Vec3 old = offset(b);
      set(b, {(*words)['X'].value_or(old.x), (*words)['Y'].value_or(old.y), (*words)['Z'].value_or(old.z)});
      return ig::Status::changed;
    }
    const bool active = offset(b) != ig::Vec3{};
    if (!active || cancelled_by_ == CancelledBy::never || !b.find(program_end_)) return ig::Status::unchanged;
    set(b, {});
    return ig::Status::changed;
  }

 private:
  ig::Vec3 offset(const ig::Block& b) const { return {b.get_or(x_, 0.0), b.get_or(y_, 0.0), b.get_or(z_, 0.0)}; }

  void set(ig::Block& b, const ig::Vec3& offset) const {
    b.set(x_, offset.x);
    b.set(y_, offset.y);
    b.set(z_, offset.z);
    b.set_translation(frame_, offset);
  }
};

const ig::Register<IsoLocalCoordinateOffset> registered;

}  // namespace
}  // namespace iso
