/// Blocks whose target is a machine position, whatever the frame is: G53, SUPA, reference and fixed points. Lengths in
/// mm.
#pragma once

#include "isogloss/sdk.hpp"

#include "isogloss/cnc/program_xyz.hpp"

namespace ig::cnc {

/// The machine position in force; where none is known, that of the program point at which the block begins, else 0,0,0.
/// `machine` is MachineCoordinate.
inline Vec3 machine_position(Block& b, const Xyz& machine, const LastProgramXyz& last) {
  const PartialVec3 known = b.get(machine);
  return known.complete() ? known.value : b.to_machine(last(b)).value_or(Vec3{});
}

/// Moves the machine to `to`, and the program point with it. False where the frame has no inverse: the program point
/// then stays.
inline bool set_machine_target(Block& b, const Xyz& machine, const Xyz& program, const Vec3& to) {
  b.set(machine, to);
  const auto point = b.to_program(to);
  if (point) b.set(program, rounded(*point));
  return point.has_value();
}

}  // namespace ig::cnc
