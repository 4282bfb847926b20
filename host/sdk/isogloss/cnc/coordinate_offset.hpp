/// A section with Offset_X, Offset_Y and Offset_Z (mm) that acts as a translation of the same name in the frame, on the
/// way from program to machine coordinates.
#pragma once

#include <string>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// A member of each syntax that keeps such a section: LocalCoordinateOffset, CoordinateOffset, WorkCoordinateShift.
class OffsetSection {
 public:
  explicit OffsetSection(const std::string& section, About about = {})
      : x_(section + ".Offset_X", about),
        y_(section + ".Offset_Y", about),
        z_(section + ".Offset_Z", about),
        frame_(section) {}

  /// The offset in force in mm; 0 on each axis that has none.
  Vec3 get(const Block& b) const { return {b.get_or(x_, 0.0), b.get_or(y_, 0.0), b.get_or(z_, 0.0)}; }
  bool has(const Block& b) const { return b.has(x_); }

  void set(Block& b, const Vec3& offset) const {
    b.set(x_, offset.x);
    b.set(y_, offset.y);
    b.set(z_, offset.z);
    b.set_translation(frame_, offset);
  }
  /// Writes the frame's entry again from the section, which was carried here or stands in the dialect's initial block.
  void restore(Block& b) const { b.set_translation(frame_, get(b)); }

 private:
  Out<double> x_, y_, z_;
  Transform frame_;
};

}  // namespace ig::cnc
