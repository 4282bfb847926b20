/// G27: a rapid to the point, with the named axes; then each of them must be at its first reference position, or the
/// control stops. Fanuc manual, "Reference position".
#include <cmath>

#include "motion/reference_position.hpp"

namespace iso {
namespace {

struct ReferenceCheck {
  static constexpr auto spec =
      ig::syntax("ReferenceCheckSyntax", "G27 moves to a point and checks that it is the reference position.")
          .after("IncrementalResolveSyntax", "McXyzSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0382",
                     "G27: {0} is at {1}, not at its reference position {2}: look for an active offset"),
  };

  ig::Call g27_{{"G27"}, "X Y Z A B C"};
  ReferenceMove move_;
  LastProgramXyz last_;
  ReferencePositions reference_;
  FurtherAxisOrder further_{"G27"};
  ig::NumberOption tolerance_{
      "tolerance", "0.001", {0, 1000}, "mm, deg", "How far from the reference position an axis may be."};

  ig::Status build(ig::Block& b) {
    const auto words = b.take(g27_);
    if (!words) return ig::Status::unchanged;
    further_.give(b);
    const auto named = move_.named(b, *words, g27_);
    if (!named) return ig::Status::changed;
    const ig::Vec3 end = named->linear.or_else(last_(b));
    const auto machine = b.to_machine(end);
    if (!machine) return not_invertible(b);
    const PartialAngles turned = move_.rotary.approach(b, named->rotary);
    move_.begin(b, words->code);
    move_.arrive(b, end, *machine, turned);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (named->linear.has(axis)) check(b, axis, (*machine)[axis]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (turned.has(axis)) check(b, axis + 3, turned.value[axis]);
    return ig::Status::changed;
  }

 private:
  void check(ig::Block& b, std::size_t axis, double position) const {
    const double reference = reference_(b, axis, 1, g27_.code(0));
    const double wanted = axis < 3 ? reference : move_.rotary.to_machine(axis - 3, position, reference);
    if (std::fabs(position - wanted) <= tolerance_) return;
    const std::string_view name = std::string_view("XYZABC").substr(axis, 1);
    b.report(ig::diag("ISO-0382"), ig::Where::word(g27_.word(0, name.front())), name, position, reference);
    b.alarm();
  }
};

const ig::Register<ReferenceCheck> reference_check_syntax;

}  // namespace
}  // namespace iso
