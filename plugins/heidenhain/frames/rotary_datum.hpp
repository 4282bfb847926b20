/// Where the program counts the angles of the rotary axes from: the preset, and the datum shift on top of it. Degrees.
#pragma once

#include <isogloss/cnc/rotary_offset.hpp>

namespace heidenhain {

using namespace ig::cnc;

/// The section that keeps the shift of A, B and C by cycle 7.
inline constexpr const char* rotary_shift = "DatumShift";

/// A member of the syntaxes that change angles of the program into angles of the machine, and back.
class RotaryDatum {
 public:
  explicit RotaryDatum(ig::Access access) : preset_("CoordinateOffset", access), shift_(rotary_shift, access) {}

  Angles get(const ig::Block& b) const {
    Angles sum = preset_.get(b).or_else({});
    const Angles shift = this->shift(b);
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += shift[axis];
    return sum;
  }
  Angles shift(const ig::Block& b) const { return shift_.get(b).or_else({}); }

 private:
  RotaryOffsetSection preset_, shift_;
};

}  // namespace heidenhain
