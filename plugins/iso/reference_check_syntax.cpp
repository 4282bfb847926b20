/// G27: by rapid to the point, with the named axes; then each of them must stand at its first reference position, or
/// the control stops. Fanuc manual, "Reference position".
#include <cmath>

#include "reference_position.hpp"

namespace iso {
namespace {

struct ReferenceCheck {
  static constexpr auto spec =
      ig::syntax("ReferenceCheckSyntax", "G27 goes to a point and checks that it is the reference position.")
          .after("IncrementalResolveSyntax", "McXyzSyntax", "LinearMotionSyntax");

  ig::Call g27_{{"G27"}, "X Y Z"};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Xyz machine_{"MachineCoordinate", ig::write};
  ig::CompoundMotion motion_;
  LastProgramXyz last_;
  ReferencePositions reference_;
  ig::NumberOption tolerance_{
      "tolerance", "0.001", {0, 1000}, "mm", "How far from the reference position an axis may stand."};

  ig::Status build(ig::Block& b) {
    const auto words = b.take(g27_);
    if (!words) return ig::Status::unchanged;
    const ig::PartialVec3 named = axis_words(*words);
    if (named.mask == 0) {
      b.report(diag("ISO-0340"), ig::Where::word(g27_.code(0)), b.text(words->code));
      return ig::Status::changed;
    }
    const ig::Vec3 end = named.or_else(last_(b));
    const auto machine = b.to_machine(end);
    if (!machine) return not_invertible(b);
    motion_.begin(b, words->code);
    motion_.rapid_to(b, end, *machine);
    b.set(program_, end);
    b.set(machine_, *machine);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (named.has(axis)) check(b, axis, (*machine)[axis]);
    return ig::Status::changed;
  }

 private:
  void check(ig::Block& b, std::size_t axis, double position) const {
    const double reference = reference_(b, axis, 1, g27_.code(0));
    if (std::fabs(position - reference) <= tolerance_) return;
    b.report(diag("ISO-0382"), ig::Where::word(g27_.word(0, "XYZ"[axis])), std::string_view(&"XYZ"[axis], 1), position,
             reference);
    b.alarm();
  }
};

const ig::Register<ReferenceCheck> registered;

}  // namespace
}  // namespace iso
