/// The point that X, Y, Z and R of a Haas cycle name, as positions or, under G91, as distances from the tool; and the
/// move to the start of the cycle.
#pragma once

#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>

namespace fanuc {

using namespace ig::cnc;

class HaasCycleTarget {
 public:
  double operator()(ig::Block& b, std::size_t axis, std::optional<double> word) const {
    const double from = last_(b)[axis];
    if (!word) return from;
    const AxisMap map = scale_and_mirror_.axis(b, axis);
    return rounded(distance_.is_incremental(b) ? from + map.factor * *word : map.position(*word));
  }
  bool is_incremental(const ig::Block& b) const { return distance_.is_incremental(b); }

  /// A rapid to X and Y of the cycle, then to its R. Returns the position of the tool.
  ig::Vec3 go_to_start(ig::Block& b, const ig::Words& words) const {
    ig::Vec3 to = last_(b);
    const double level = (*this)(b, 2, words['R']);
    for (std::size_t axis = 0; axis < 2; ++axis) to[axis] = (*this)(b, axis, words["XY"[axis]]);
    motion_.begin(b, words.code);
    motion_.rapid_to(b, to);
    to.z = level;
    motion_.rapid_to(b, to);
    b.set(program_, to);
    return to;
  }

 private:
  DistanceMode distance_;
  ScaleAndMirror scale_and_mirror_;
  LastProgramXyz last_;
  ig::CompoundMotion motion_;
  ig::Xyz program_{"ProgramXyz", ig::write};
};

}  // namespace fanuc
