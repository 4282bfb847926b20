/// Where the tool stands, in program coordinates.
#pragma once

#include <cmath>
#include <optional>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// To 1e-9 mm: what an inverted frame adds below that is noise.
inline double rounded(double mm) {
  constexpr double no_fraction = 0x1.8p52;                      // what is added to it is rounded to a whole number
  if (!(std::fabs(mm) < 2e6)) return mm;                        // has no such decimals, and must not overflow
  return ((mm * 1e9 + no_fraction) - no_fraction) / 1e9 + 0.0;  // + 0.0: no -0
}
inline Vec3 rounded(const Vec3& p) { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

inline double length(const Vec3& way) { return std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z); }

/// The program point at which the block begins. There are two ways back from where the tool stands: through the frame
/// of *this* block when the frame changed under a resting spindle (G55, G43, G68), and through the frame of the block
/// that carries the point, which is the program point as it was carried, when the tip rests in the workpiece. A frame
/// that moves with the rotary axes (tool centre point control) takes the tip along: the second way. Where a block both
/// changes the frame and turns the axes, PivotTransformationSyntax has computed the point with the axes at the start.
class LastProgramXyz {
 public:
  /// The first way where the frame changed in this block, else the second.
  Vec3 operator()(Block& b) const {
    if (b.frame_changed()) {
      const PartialVec3 start = b.get(start_);
      if (start.complete()) return start.value;
      if (const auto program = of_resting_machine(b)) return *program;
    }
    return as_carried(b);
  }

  /// Where the machine stands, seen in the frame of this block; nothing where that is not known or has no inverse.
  std::optional<Vec3> of_resting_machine(Block& b) const {
    const PartialVec3 machine = b.get(machine_);
    if (!machine.complete()) return std::nullopt;
    const auto program = b.to_program(machine.value);
    return program ? std::optional(rounded(*program)) : std::nullopt;
  }
  /// The program point of before, whatever the frame is now. 0,0,0 where nothing is known.
  Vec3 as_carried(const Block& b) const { return b.get(program_).or_else({}); }

 private:
  Xyz program_{"ProgramXyz", previous};
  Xyz machine_{"MachineCoordinate", previous};
  Xyz start_{"PivotTransform.Start",
             read,
             {Life::block, "mm", "Where the block begins, in its own frame, rotary axes at the start."}};
};

/// A member of each syntax that must tell positions from distances.
class DistanceMode {
 public:
  bool is_incremental(const Block& b) const { return b.is(term_, g91_); }

 private:
  In<Symbol> term_{"PositioningMode.Term"};
  Name g91_{"G91"};
};

}  // namespace ig::cnc
