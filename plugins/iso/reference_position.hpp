/// Reference positions of the machine's axes, for G27 to G30.
#pragma once

#include "diagnostics.hpp"
#include "program_xyz_util.hpp"

namespace iso {

/// A member of each syntax that goes to a reference position. X, Y and Z are axes 0, 1 and 2.
class ReferencePositions {
 public:
  /// mm in machine coordinates, of position 1 to 4; machine zero, said at `code`, where the machine does not know it.
  double operator()(ig::Block& b, std::size_t axis, std::uint32_t which, ig_field code) const {
    const char name = "XYZ"[axis];
    double position = 0;
    if (axes_ && axes_->reference(axes_->self, name, which, &position) != 0) return position;
    b.report(diag("ISO-0341"), ig::Where::word(code), double(which), std::string_view(&name, 1));
    return 0;
  }

 private:
  ig::Service<ig_machine_axis_1> axes_{"isogloss.machine-axis/1", ig::Need::optional, "Reference positions."};
};

/// The axis words of a call, as a point of which some axes have a value.
inline ig::PartialVec3 axis_words(const ig::Words& words) {
  ig::PartialVec3 named;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const auto word = words["XYZ"[axis]]) {
      named.mask |= 1u << axis;
      named.value[axis] = *word;
    }
  return named;
}

inline ig::Status not_invertible(ig::Block& b) {
  b.report(diag("ISO-0332"), ig::Where::block());
  return ig::Status::changed;
}

}  // namespace iso
