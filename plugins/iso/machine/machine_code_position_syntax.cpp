/// Codes of the machine's builder that send axes to a position, as the table MachineCodes says: a rapid in machine
/// coordinates, by the axes that the row names.
#include <isogloss/cnc/machine_codes.hpp>
#include <isogloss/cnc/machine_target.hpp>
#include <isogloss/cnc/motion_event.hpp>

#include "motion/reference_position.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct MachineCodePosition {
  static constexpr auto spec =
      ig::syntax("MachineCodePositionSyntax", "Codes of the machine's builder that go to a position of the machine.")
          .after("McXyzSyntax", "McAbcSyntax", "LinearMotionSyntax", "PivotTransformationSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0572",
                     "{0} stands in a block that moves, so its position is not approached: write it alone"),
  };

  RecordedMachineCodes recorded_;
  ReferenceMove move_;
  BlockMotion motion_;
  TurnedFrame turned_frame_;
  LastProgramXyz last_;
  ig::Xyz machine_{"MachineCoordinate", ig::read};

  ig::Status build(ig::Block& b) const {
    const bool any = recorded_.for_each(b, IG_CODE_MOVES, [&](const ig_machine_code& row) { move(b, row); });
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  void move(ig::Block& b, const ig_machine_code& row) const {
    if (motion_.is_moving(b)) {
      b.report(ig::diag("ISO-0572"), ig::Where::block(), ig::to_view(row.name));
      return;
    }
    const PartialAngles angles = rotary(b, row);
    const ig::PartialVec3 named{row.axes & 7u, {row.position[0], row.position[1], row.position[2]}};
    if (named.mask == 0 && angles.mask == 0) return;
    const ig::Vec3 to = named.or_else(machine_position(b, machine_, last_));
    turned_frame_.turn(b, angles);
    if (const auto point = b.to_program(to)) {
      move_.begin(b, b.symbol(ig::to_view(row.name)));
      move_.arrive(b, rounded(*point), to, angles);
    } else {
      not_invertible(b);
    }
  }

  /// The angles to which the rotary axes of the row turn.
  PartialAngles rotary(ig::Block& b, const ig_machine_code& row) const {
    PartialAngles out;
    const Angles from = move_.rotary.present(b);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((row.axes >> (axis + 3) & 1u) == 0) continue;
      if (!move_.rotary.accept(b, axis, row.position[axis + 3])) continue;
      out.mask |= 1u << axis;
      out.value[axis] = move_.rotary.to_machine(axis, from[axis], row.position[axis + 3]);
    }
    return out;
  }
};

const ig::Register<MachineCodePosition> machine_code_position_syntax;

}  // namespace
}  // namespace iso
