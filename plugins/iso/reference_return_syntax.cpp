/// G28 and G30: by rapid to the intermediate point that the words name, then to a reference position of the machine,
/// both with the named axes only. `G91 G28 Z0` goes straight up; `G90 G28 Z0` goes to program Z0 first, as the control
/// does. Fanuc manual, "Reference position".
#include "reference_position.hpp"

namespace iso {
namespace {

enum class WithoutAxes { nothing, all };

struct ReferenceReturn {
  static constexpr auto spec = ig::syntax("ReferenceReturnSyntax", "G28 and G30 return to a reference position.")
                                   .after("IncrementalResolveSyntax", "McXyzSyntax", "LinearMotionSyntax");

  ig::Call g28_{{"G28"}, "X Y Z"};
  ig::Call g30_{{"G30"}, "X Y Z P[]"};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Xyz machine_{"MachineCoordinate", ig::write};
  ig::CompoundMotion motion_;
  LastProgramXyz last_;
  ReferencePositions reference_;
  ig::Choice<WithoutAxes> without_axes_{"without-axes", "nothing|all", "nothing",
                                        "What G28 or G30 without an axis word returns."};

  ig::Status build(ig::Block& b) {
    bool any = false;
    if (const auto words = b.take(g28_)) {
      any = true;
      go(b, axis_words(*words), 1, words->code, g28_.code(0));
    }
    if (const auto words = b.take(g30_)) {
      const double which = (*words)['P'].value_or(2);
      if (which == 2 || which == 3 || which == 4)
        go(b, axis_words(*words), static_cast<std::uint32_t>(which), words->code, g30_.code(0));
      else
        b.report(diag("ISO-0380"), ig::Where::word(g30_.code(0)), which);
      any = true;
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  void go(ig::Block& b, const ig::PartialVec3& named, std::uint32_t which, ig::Symbol code, ig_field word) const {
    const ig::Vec3 from = last_(b);
    if (named.mask == 0 && without_axes_ == WithoutAxes::nothing) {
      b.report(diag("ISO-0340"), ig::Where::word(word), b.text(code));
      return;
    }
    const ig::PartialVec3 returned = named.mask == 0 ? ig::PartialVec3{7, from} : named;
    const ig::Vec3 intermediate = returned.or_else(from);
    const auto over = b.to_machine(intermediate);
    if (!over) {
      not_invertible(b);
      return;
    }
    ig::Vec3 reference = *over;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (returned.has(axis)) reference[axis] = reference_(b, axis, which, word);
    const auto end = b.to_program(reference);
    if (!end) {
      not_invertible(b);
      return;
    }

    motion_.begin(b, code);
    motion_.rapid_to(b, intermediate, *over);
    motion_.rapid_to(b, rounded(*end), reference);
    b.set(program_, rounded(*end));
    b.set(machine_, reference);
  }
};

const ig::Register<ReferenceReturn> registered;

}  // namespace
}  // namespace iso
