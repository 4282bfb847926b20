// Cycle 7 together with other transformations: each acts in the system that the earlier ones have made.
#pragma once

#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/sdk.hpp>

#include "frames/rotary_datum.hpp"
#include "frames/scaling.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// The words of cycle 7, for the syntaxes that shift the datum outside a tilted plane and inside it.
class DatumWords {
 public:
  bool stand_in(const ig::Block& b) const { return b.find(call_).has_value(); }

  /// Takes the words; axes that are not named keep `old`. The shift of rotary axes is kept in DatumShift.
  ig::Vec3 take(ig::Block& b, const ig::Vec3& old) const {
    ig::Vec3 shift = old;
    for (std::size_t row = 0; row < 2; ++row) {
      ig_value v[6];
      const std::uint32_t named = b.take_many(call_.row(row), 6, v);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if ((named >> axis & 1u) != 0) shift[axis] = v[axis].number + (row == 1 ? old[axis] : 0);
      Angles angles = rotary_.get(b).or_else({});
      for (std::size_t axis = 0; axis < 3; ++axis)
        if ((named >> (axis + 3) & 1u) != 0) angles[axis] = v[axis + 3].number + (row == 1 ? angles[axis] : 0);
      rotary_.set(b, angles);
    }
    b.take_code(call_.codes(), call_.code_count());
    return shift;
  }

  /// A preset cancels the shift of rotary axes, too.
  void end_rotary(ig::Block& b) const { rotary_.set(b, Angles{}); }

 private:
  RotaryOffsetSection rotary_{rotary_shift};
  ig::Call call_{{"DATUM", "IDATUM"}, "X Y Z A B C"};
};

/// A shift that was defined after a rotation, a mirror image or a scaling: it lies along the axes, and in the measure,
/// that these have made.
class TurnedShift {
 public:
  explicit TurnedShift(const std::string& section)
      : shift_(section, ig::read | ig::write, {ig::Life::modal, "mm", "Datum shift as programmed."}),
        rotated_(section + ".IsRotated", {ig::Life::modal, "", "The shift came after the rotation."}),
        mirrored_(section + ".IsMirrored", {ig::Life::modal, "", "The shift came after the mirror image."}),
        scaled_(section + ".IsScaled", {ig::Life::modal, "", "The shift came after the scaling."}) {}

  /// True where a shift was set, even to zeros.
  bool was_set(const ig::Block& b) const { return b.get(shift_).mask != 0; }
  bool is_here(const ig::Block& b) const { return b.has(rotated_) || b.has(mirrored_) || b.has(scaled_); }
  ig::Vec3 get(const ig::Block& b) const {
    const ig::PartialVec3 v = b.get(shift_);
    return {v.has(0) ? v.value.x : 0, v.has(1) ? v.value.y : 0, v.has(2) ? v.value.z : 0};
  }
  void set(ig::Block& b, const ig::Vec3& shift) const { b.set(shift_, shift); }

  /// Notes which transformations are in force when the shift of this block begins.
  void begin(ig::Block& b, bool is_rotated) const {
    keep(b, rotated_, is_rotated);
    keep(b, mirrored_, b.has(mirror_term_));
    keep(b, scaled_, scaling_.is_on(b));
  }
  /// A shift of zeros comes after none.
  void forget(ig::Block& b) const {
    for (const ig::Out<bool>* flag : {&rotated_, &mirrored_, &scaled_}) keep(b, *flag, false);
  }
  void end(ig::Block& b) const {
    for (std::size_t axis = 0; axis < 3; ++axis) b.erase(shift_.id(axis));
    forget(b);
  }

  /// The shift along the axes of the outer system. What has ended no longer precedes it.
  ig::Vec3 around(ig::Block& b, const Mat4* rotation) const {
    ig::Vec3 v = get(b);
    if (b.has(scaled_)) {
      if (!scaling_.is_on(b)) keep(b, scaled_, false);
      for (std::size_t axis = 0; axis < 3; ++axis) v[axis] *= scaling_.along(b, axis);
    }
    if (b.has(mirrored_)) {
      if (!b.has(mirror_term_)) keep(b, mirrored_, false);
      const ig::PartialVec3 mirror = b.get(mirror_);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (mirror.has(axis)) v[axis] = -v[axis];
    }
    if (b.has(rotated_)) {
      if (rotation == nullptr) keep(b, rotated_, false);
      if (rotation != nullptr) v = mapped(*rotation, v);
    }
    return v;
  }

 private:
  static void keep(ig::Block& b, const ig::Out<bool>& flag, bool value) {
    if (value)
      b.set(flag, true);
    else if (b.has(flag))
      b.erase(flag);
  }

  ig::Xyz shift_;
  ig::Out<bool> rotated_, mirrored_, scaled_;
  ig::In<ig::Symbol> mirror_term_{"MirrorImage.Term"};
  ig::Xyz mirror_{"MirrorImage", ig::read};
  ScalingInForce scaling_;
};

}  // namespace heidenhain
