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
  /// Its rows are the axes of the plane. Where the work offset scales, they are not unit vectors.
  Mat4 get(const ig::Block& b) const {
    Mat4 outer;
    const Mat4 plane = tilt_.get(b);
    return b.get(offset_, outer) ? product(plane, outer) : plane;
  }

 private:
  TiltFrame tilt_{ig::read};
  ig::Transform offset_{"WorkOffsetFrame", ig::read};
};

}  // namespace iso
