/// Where the tool stands, in program coordinates.
#pragma once

#include <cmath>
#include <isogloss/sdk.hpp>

namespace iso {

/// To 1e-9 mm: what an inverted frame adds below that is noise.
inline double rounded(double mm) {
  return std::round(mm * 1e9) / 1e9 + 0.0;  // + 0.0: no -0
}
inline ig::Vec3 rounded(const ig::Vec3& p) { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

/// The program point at which the block begins: that of the block before, unless the frame changed in this block. Then
/// the tool rests where it is and its program point is another one. 0,0,0 where nothing is known.
class LastProgramXyz {
 public:
  ig::Vec3 operator()(ig::Block& b) const {
    if (b.frame_changed()) {
      const ig::PartialVec3 machine = b.get(machine_);
      if (machine.complete())
        if (const auto program = b.to_program(machine.value)) return rounded(*program);
    }
    return b.get(program_).or_else({});
  }

 private:
  ig::Xyz program_{"ProgramXyz", ig::previous};
  ig::Xyz machine_{"MachineCoordinate", ig::previous};
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
