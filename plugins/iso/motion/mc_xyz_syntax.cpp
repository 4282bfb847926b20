/// From program to machine coordinates: the point of the block and the steps of a compound motion, through all entries
/// of the frame. Where only the frame changed, the tool rests: its machine point stays and its program point changes.
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct McXyz {
  static constexpr auto spec = ig::syntax("McXyzSyntax", "Machine coordinates of what was programmed.")
                                   .after("ToolHeightOffsetSyntax", "IsoLocalCoordinateOffsetSyntax",
                                          "IsoCoordinateOffsetSyntax", "ProgramXyzSyntax")
                                   .before("CircularMotionSyntax", "LinearMotionSyntax");

  ig::Xyz program_{"ProgramXyz", ig::read | ig::write | ig::wake};
  ig::Xyz machine_{"MachineCoordinate", ig::read | ig::write};
  ig::Fields frame_{"frame", "ProgramToMcTransform.*", ig::read | ig::wake,
                    "Entries of the frame whose change makes the program point be computed again.", IG_TRANSFORM};
  ig::Xyz item_program_{"CompoundMotion.Items[].ProgramXyz", ig::read | ig::wake};
  ig::Xyz item_machine_{"CompoundMotion.Items[].MachineCoordinate", ig::write};

  /// The first program point is that of the home position.
  ig::Status restart(ig::Block& b) { return follow_frame(b); }

  ig::Status build(ig::Block& b) {
    if (!b.is_fresh(program_) && !take_end_of_steps(b))
      return b.frame_changed() ? follow_frame(b) : ig::Status::unchanged;
    b.map_records(item_program_.ids(), item_machine_.ids());
    const bool is_programmed = b.is_fresh(machine_.id(0));  // G53 writes all three axes
    if (is_programmed) return ig::Status::changed;
    const auto machine = b.to_machine(b.get(program_).or_else({}));
    if (machine) b.set(machine_, *machine);
    return ig::Status::changed;
  }

 private:
  /// For a cycle that writes nothing but its steps: the tool is at the end of the last step.
  bool take_end_of_steps(ig::Block& b) const {
    for (std::uint32_t step = b.count(item_program_.id(0)); step-- > 0;) {
      ig_value at[3];
      if (b.record(step, item_program_.ids(), 3, at) != 7u) continue;
      b.set(program_, {at[0].number, at[1].number, at[2].number});
      return true;
    }
    return false;
  }

  ig::Status follow_frame(ig::Block& b) const {
    const ig::PartialVec3 machine = b.get(machine_);
    if (!machine.complete()) return ig::Status::unchanged;
    const auto program = b.to_program(machine.value);
    if (!program) {
      b.report(ig::diag("ISO-0332"), ig::Where::block());
      return ig::Status::unchanged;
    }
    b.amend(program_, rounded(*program));
    return ig::Status::changed;
  }
};

const ig::Register<McXyz> mc_xyz_syntax;

}  // namespace
}  // namespace iso
