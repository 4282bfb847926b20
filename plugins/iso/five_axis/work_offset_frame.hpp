/// The tilted plane as it lies in the machine: on some controls a work offset also rotates, scales or mirrors (settable
/// frames of a SINUMERIK, basic rotation of a TNC). Such a control's plugin writes the entry WorkOffsetFrame.
#pragma once

#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

/// A member of each syntax that needs directions of the plane in machine coordinates.
class PlaneInMachine {
 public:
  /// Its rows are the axes of the plane, unit vectors: directions do not scale.
  Mat4 get(const ig::Block& b) const {
    Mat4 outer, plane = tilt_.get(b);
    if (!b.get(offset_, outer)) return plane;
    plane = product(plane, outer);
    for (std::size_t row = 0; row < 12; row += 4)
      if (const auto axis = unit({plane[row], plane[row + 1], plane[row + 2]}))
        for (std::size_t i = 0; i < 3; ++i) plane[row + i] = (*axis)[i];
    return plane;
  }

 private:
  TiltFrame tilt_{ig::read};
  ig::Transform offset_{"WorkOffsetFrame", ig::read};
};

}  // namespace iso
