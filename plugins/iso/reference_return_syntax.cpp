/// G28: by rapid to the intermediate point that the words name, then to the first reference position of the machine,
/// both with the named axes only. `G91 G28 Z0` goes straight up; `G90 G28 Z0` goes to program Z0 first, as the control
/// does.
#include "diagnostics.hpp"
#include "program_xyz_util.hpp"

namespace iso {
namespace {

struct ReferenceReturn {
  static constexpr auto spec = ig::syntax("ReferenceReturnSyntax", "G28 return to the reference position.")
                                   .after("IncrementalResolveSyntax", "McXyzSyntax", "LinearMotionSyntax");

  ig::Call g28_{{"G28"}, "X Y Z"};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Xyz machine_{"MachineCoordinate", ig::write};
  ig::CompoundMotion motion_;
  LastProgramXyz last_;
  ig::Service<ig_machine_axis_1> axes_{"isogloss.machine-axis/1", ig::Need::optional, "Reference positions."};

  ig::Status build(ig::Block& b) {
    const auto words = b.take(g28_);
    if (!words) return ig::Status::unchanged;
    const ig::Vec3 from = last_(b);
    ig::Vec3 intermediate = from;
    for (std::size_t axis = 0; axis < 3; ++axis) intermediate[axis] = (*words)["XYZ"[axis]].value_or(from[axis]);
    if (words->mask == 0) {
      b.report(diag("ISO-0340"), ig::Where::word(g28_.code(0)));
      return ig::Status::changed;
    }
    const auto over = b.to_machine(intermediate);
    if (!over) return not_invertible(b);
    ig::Vec3 reference = *over;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((*words)["XYZ"[axis]]) reference[axis] = reference_of(b, axis);
    const auto end = b.to_program(reference);
    if (!end) return not_invertible(b);

    motion_.begin(b, words->code);
    motion_.rapid_to(b, intermediate, *over);
    motion_.rapid_to(b, rounded(*end), reference);
    b.set(program_, rounded(*end));
    b.set(machine_, reference);
    return ig::Status::changed;
  }

 private:
  double reference_of(ig::Block& b, std::size_t axis) const {
    const char name = "XYZ"[axis];
    double position = 0;
    if (axes_ && axes_->reference(axes_->self, name, 1, &position) != 0) return position;
    b.report(diag("ISO-0341"), ig::Where::word(g28_.code(0)), std::string_view(&name, 1));
    return 0;
  }
  static ig::Status not_invertible(ig::Block& b) {
    b.report(diag("ISO-0332"), ig::Where::block());
    return ig::Status::changed;
  }
};

const ig::Register<ReferenceReturn> registered;

}  // namespace
}  // namespace iso
