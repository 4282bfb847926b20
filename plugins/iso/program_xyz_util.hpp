/// Where the tool stands, in program coordinates.
#pragma once

#include <cmath>
#include <optional>

#include <isogloss/sdk.hpp>

namespace iso {

/// To 1e-9 mm: what an inverted frame adds below that is noise.
inline double rounded(double mm) {
  constexpr double no_fraction = 0x1.8p52;                      // what is added to it is rounded to a whole number
  if (!(std::fabs(mm) < 2e6)) return mm;                        // has no such decimals, and must not overflow
  return ((mm * 1e9 + no_fraction) - no_fraction) / 1e9 + 0.0;  // + 0.0: no -0
}
inline ig::Vec3 rounded(const ig::Vec3& p) { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

inline double length(const ig::Vec3& way) { return std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z); }

/// The program point at which the block begins. There are two ways back from where the tool stands: through the frame
/// of *this* block when the frame changed under a resting spindle (G55, G43, G68), and through the frame of the block
/// that carries the point, which is the program point as it was carried, when the tip rests in the workpiece. A frame
/// that moves with the rotary axes (tool centre point control) takes the tip along: the second way. Where a block both
/// changes the frame and turns the axes, PivotTransformationSyntax has computed the point with the axes at the start.
class LastProgramXyz {
 public:
  /// The first way where the frame changed in this block, else the second.
  ig::Vec3 operator()(ig::Block& b) const {
    if (b.frame_changed()) {
      const ig::PartialVec3 start = b.get(start_);
      if (start.complete()) return start.value;
      if (const auto program = of_resting_machine(b)) return *program;
    }
    return as_carried(b);
  }

  /// Where the machine stands, seen in the frame of this block; nothing where that is not known or has no inverse.
  std::optional<ig::Vec3> of_resting_machine(ig::Block& b) const {
    const ig::PartialVec3 machine = b.get(machine_);
    if (!machine.complete()) return std::nullopt;
    const auto program = b.to_program(machine.value);
    return program ? std::optional(rounded(*program)) : std::nullopt;
  }
  /// The program point of before, whatever the frame is now. 0,0,0 where nothing is known.
  ig::Vec3 as_carried(const ig::Block& b) const { return b.get(program_).or_else({}); }

 private:
  ig::Xyz program_{"ProgramXyz", ig::previous};
  ig::Xyz machine_{"MachineCoordinate", ig::previous};
  ig::Xyz start_{"PivotTransform.Start",
                 ig::read,
                 {ig::Life::block, "mm", "Where the block begins, in its own frame, rotary axes at the start."}};
};

/// A member of each syntax that must tell positions from distances.
class DistanceMode {
 public:
  bool is_incremental(const ig::Block& b) const { return b.is(term_, g91_); }

 private:
  ig::In<ig::Symbol> term_{"PositioningMode.Term"};
  ig::Name g91_{"G91"};
};

}  // namespace iso
