/// The base frame, which acts after each settable frame: row BASE of the table of work offsets.
#pragma once

#include <isogloss/cnc/work_origin.hpp>
#include <isogloss/sdk.hpp>

#include "frames/settable_shape.hpp"

namespace siemens {

using namespace ig::cnc;

/// Raised in a block in which G53 has become SUPA: of all frames, the base frame remains in force.
inline constexpr const char* keeps_base_signal = "CoordinateOffset.~KeepsBase";

/// A member of each syntax that needs the base frame alone.
class BaseFrame {
 public:
  Mat4 get() const {
    const SettableShape shape = shapes_.get("BASE");
    const auto origin = table_ ? linear_origin(table_, "BASE") : std::nullopt;
    return at_origin(shape.matrix(), origin.value_or(ig::Vec3{}) + shape[ShapePart::fine]);
  }

 private:
  ig::Service<ig_work_offset_1> table_{"isogloss.work-offset/1", ig::Need::optional, "The base frame."};
  ShapeTable shapes_;
};

/// The point that the frame maps to `p`. The axes of the frame are square to each other.
inline ig::Vec3 unmapped(const Mat4& m, const ig::Vec3& p) {
  const ig::Vec3 way{p.x - m[12], p.y - m[13], p.z - m[14]};
  ig::Vec3 out;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const ig::Vec3 own{m[4 * axis], m[4 * axis + 1], m[4 * axis + 2]};
    out[axis] = scalar_product(way, own) / scalar_product(own, own);
  }
  return out;
}

}  // namespace siemens
