/// X, Y and Z become the program point at the end of the block. Axes that are not named keep their positions.
#include <isogloss/cnc/program_xyz.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct ProgramXyz {
  static constexpr auto spec =
      ig::syntax("ProgramXyzSyntax", "Turns X Y Z into the program point.")
          .after("UnitModeSyntax", "DrillingCycleSyntax", "IncrementalResolveSyntax", "MachineCoordSelectSyntax")
          .before("McXyzSyntax");

  ig::Xyz words_{"Parsing", ig::take | ig::wake};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Signal axis_words_void_{"MachineCoordSelect.~AxisWordsVoid", ig::read};
  LastProgramXyz last_;

  ig::Status build(ig::Block& b) {
    if (b.is_raised(axis_words_void_)) return ig::Status::unchanged;
    const ig::PartialVec3 named = b.take(words_);
    if (named.mask == 0) return ig::Status::unchanged;
    b.set(program_, named.complete() ? named.value : named.or_else(last_(b)));
    return ig::Status::changed;
  }
};

const ig::Register<ProgramXyz> program_xyz_syntax;

}  // namespace
}  // namespace iso
