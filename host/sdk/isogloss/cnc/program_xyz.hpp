/// The program point at which a block begins, and the distance mode. Lengths in mm.
#pragma once

#include <cmath>
#include <optional>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// Rounded to 1e-9 mm: smaller digits are noise of an inverted frame.
inline double rounded(double mm) {
  constexpr double no_fraction = 0x1.8p52;                      // adding it rounds to a whole number
  if (!(std::fabs(mm) < 2e6)) return mm;                        // has no such decimals; avoids overflow
  return ((mm * 1e9 + no_fraction) - no_fraction) / 1e9 + 0.0;  // + 0.0: no -0
}
inline Vec3 rounded(const Vec3& p) { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

inline double length(const Vec3& way) { return std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z); }

/// The program point at which the block begins. It can be computed in two ways. Where the frame changed while the axes
/// rest (G55, G43, G68), the machine position is mapped back through the frame of *this* block. Otherwise the tip rests
/// in the workpiece and the carried program point is valid; a frame that moves with the rotary axes (tool centre point
/// control) takes the tip along, so it belongs here. Where a block changes the frame and also turns the axes,
/// PivotTransformationSyntax has computed the point, with the axes at their start.
class LastProgramXyz {
 public:
  /// The first way where the frame changed in this block, else the second.
  Vec3 operator()(Block& b) const { return b.frame_changed() ? in_changed_frame(b) : as_carried(b); }

  /// The machine position, seen in the frame of this block; nothing where the position is not known or the frame has no
  /// inverse.
  std::optional<Vec3> of_resting_machine(Block& b) const {
    const PartialVec3 machine = b.get(machine_);
    if (!machine.complete()) return std::nullopt;
    const auto program = b.to_program(machine.value);
    return program ? std::optional(rounded(*program)) : std::nullopt;
  }
  /// The carried program point, whatever the frame is now; 0,0,0 where none is known.
  Vec3 as_carried(const Block& b) const { return b.get(program_).or_else({}); }

 private:
  [[gnu::noinline]] Vec3 in_changed_frame(Block& b) const {
    const PartialVec3 start = b.get(start_);
    if (start.complete()) return start.value;
    const auto program = of_resting_machine(b);
    return program ? *program : as_carried(b);
  }

  Xyz program_{"ProgramXyz", previous};
  Xyz machine_{"MachineCoordinate", previous};
  Xyz start_{"PivotTransform.Start",
             read,
             {Life::block, "mm", "Where the block begins, in its own frame, rotary axes at the start."}};
};

/// A member of each syntax that must tell positions (G90) from distances (G91).
class DistanceMode {
 public:
  bool is_incremental(const Block& b) const { return b.is(term_, g91_); }

 private:
  In<Symbol> term_{"PositioningMode.Term"};
  Name g91_{"G91"};
};

}  // namespace ig::cnc
