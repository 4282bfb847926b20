/// G90 and G91: whether axis words are positions or distances. Only the mode is written here; IncrementalResolveSyntax
/// turns distances into positions, and so do the canned cycles, whose R and Z start from other points.
#include <isogloss/cnc/modal_group.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct PositioningMode {
  static constexpr auto spec = ig::syntax("PositioningModeSyntax", "G90/G91 absolute or incremental positions.")
                                   .before("ProgrammableDataInputSyntax", "CannedCycleResolveSyntax",
                                           "IncrementalResolveSyntax", "MachineCoordSelectSyntax");

  ig::Codes modes_{"G90", "G91"};
  ig::Out<ig::Symbol> term_{"PositioningMode.Term"};
  ig::Out<ig::Symbol> mode_{"PositioningMode.Mode"};
  ig::Name absolute_{"Absolute"}, incremental_{"Incremental"};

  ig::Status build(ig::Block& b) {
    const auto mode = take_modal(b, modes_);
    if (!mode) return ig::Status::unchanged;
    b.set(term_, modes_.name(*mode));
    b.set(mode_, *mode == 0 ? absolute_ : incremental_);
    return ig::Status::changed;
  }
};

const ig::Register<PositioningMode> positioning_mode_syntax;

}  // namespace
}  // namespace iso
