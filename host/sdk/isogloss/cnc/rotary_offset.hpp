/// Offsets of the rotary axes: what the work coordinate systems add to programmed A, B and C. Degrees; index 0 is A.
#pragma once

#include <string>

#include "isogloss/sdk.hpp"

#include "isogloss/cnc/rotary_words.hpp"

namespace ig::cnc {

/// Offset_A, Offset_B and Offset_C of a section; an axis that never got an offset has no field. A member of each syntax
/// that keeps such a section.
class RotaryOffsetSection {
 public:
  explicit RotaryOffsetSection(const std::string& section, Access access = read | write)
      : ids_{offset(section + ".Offset_A", access), offset(section + ".Offset_B", access),
             offset(section + ".Offset_C", access)} {}

  PartialAngles get(const Block& b) const { return angles_of(b, ids_); }
  /// True when an axis that the machine has is offset; `machine` tells which there are, as ToolKinematics does.
  template <class Machine>
  bool acts_on(const Block& b, const Machine& machine) const {
    const PartialAngles offset = get(b);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (machine.has(axis) && offset.value[axis] != 0) return true;
    return false;
  }
  /// Writes the axes whose offset changes; true when there was one.
  bool set(Block& b, const Angles& to) const {
    const PartialAngles old = get(b);
    bool any = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (to[axis] == old.value[axis]) continue;
      b.set(ids_[axis], to[axis]);
      any = true;
    }
    return any;
  }

 private:
  static ig_field offset(const std::string& path, Access access) {
    return Field<double>(path, access, {Life::modal, "deg", "Where the section puts the origin of the axis."}).id();
  }
  std::array<ig_field, 3> ids_;
};

/// The sum that is added to a programmed angle: RotaryOffset.A, B and C, present where the sum is not 0.
/// RotaryOffsetSyntax writes it.
class RotaryOffsets {
 public:
  explicit RotaryOffsets(Access access = read)
      : ids_{offset("RotaryOffset.A", access), offset("RotaryOffset.B", access), offset("RotaryOffset.C", access)} {}

  bool any(const Block& b) const { return b.has_any(all_); }
  Angles get(const Block& b) const { return angles_of(b, ids_).or_else({}); }
  void set(Block& b, std::size_t axis, double to) const {
    if (to != 0)
      b.set(ids_[axis], to);
    else
      b.erase(ids_[axis]);
  }

  /// The machine angle that a word names. Where the sign of the word is a direction, the result keeps that sign.
  static double to_machine(double word, double offset, Rollover rollover) {
    if (offset == 0) return word;
    if (rollover != Rollover::signed_direction) return word + offset;
    double position = std::fmod(std::fabs(word) + offset, 360);
    if (position < 0) position += 360;
    if (!(word < 0)) return position;
    return position > 0 ? -position : -360;  // 0 cannot carry a sign
  }

 private:
  static ig_field offset(const char* path, Access access) {
    return Field<double>(path, access, {Life::modal, "deg", "What is added to a programmed angle of the axis."}).id();
  }
  std::array<ig_field, 3> ids_;
  AnyOf all_{ids_};
};

/// A, B and C of a code that sets coordinates, for axes that the machine has. The other ones are reported at their
/// words.
inline PartialAngles rotary_coordinates(Block& b, const RotaryWords& machine, const Words& words, const Call& call) {
  PartialAngles named;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto word = words[rotary_names[axis]];
    if (!word || !machine.accept(b, axis, *word, call.word(words.row, rotary_names[axis]))) continue;
    named.mask |= 1u << axis;
    named.value[axis] = *word;
  }
  return named;
}

}  // namespace ig::cnc
