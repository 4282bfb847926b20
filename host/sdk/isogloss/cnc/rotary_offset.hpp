/// Offsets of the rotary axes: what the work coordinate systems add to A, B and C. Degrees; index 0 is A.
#pragma once

#include <string>

#include "isogloss/sdk.hpp"

#include "isogloss/cnc/rotary_words.hpp"

namespace ig::cnc {

/// Offset_A, Offset_B and Offset_C of a section. A member of each syntax that keeps one. An axis to which nobody gave
/// an offset has no field.
class RotaryOffsetSection {
 public:
  explicit RotaryOffsetSection(const std::string& section, Access access = read | write)
      : ids_{offset(section + ".Offset_A", access), offset(section + ".Offset_B", access),
             offset(section + ".Offset_C", access)} {}

  PartialAngles get(const Block& b) const { return angles_of(b, ids_); }
  /// Writes the axes that change. True when there was one.
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

/// What is added to a programmed angle: RotaryOffset.A, B and C, present where it is not 0. RotaryOffsetSyntax writes
/// it.
class RotaryOffsets {
 public:
  explicit RotaryOffsets(Access access = read)
      : ids_{offset("RotaryOffset.A", access), offset("RotaryOffset.B", access), offset("RotaryOffset.C", access)} {}

  bool any(const Block& b) const { return b.has(ids_[0]) || b.has(ids_[1]) || b.has(ids_[2]); }
  Angles get(const Block& b) const { return angles_of(b, ids_).or_else({}); }
  void set(Block& b, std::size_t axis, double to) const {
    if (to != 0)
      b.set(ids_[axis], to);
    else
      b.erase(ids_[axis]);
  }

  /// The machine angle that a word names. Where the sign of a word is a direction it stays one.
  static double to_machine(double word, double offset, Rollover rollover) {
    if (offset == 0) return word;
    if (rollover != Rollover::signed_direction) return word + offset;
    double position = std::fmod(std::fabs(word) + offset, 360);
    if (position < 0) position += 360;
    if (!(word < 0)) return position;
    return position > 0 ? -position : -360;  // 0 has no sign
  }

 private:
  static ig_field offset(const char* path, Access access) {
    return Field<double>(path, access, {Life::modal, "deg", "What is added to a programmed angle of the axis."}).id();
  }
  std::array<ig_field, 3> ids_;
};

namespace detail {

inline bool has_rotary(const ig_work_offset_1& table) {
  constexpr std::size_t with_rotary = offsetof(ig_work_offset_1, set_rotary) + sizeof table.set_rotary;
  return table.struct_size >= with_rotary && table.get_rotary != nullptr && table.set_rotary != nullptr;
}

}  // namespace detail

/// Of a set of the table; nothing where the table keeps none.
inline std::optional<Angles> rotary_origin(const Service<ig_work_offset_1>& service, std::string_view id) {
  const ig_work_offset_1& table = *service.operator->();
  Angles out{};
  if (!detail::has_rotary(table) || table.get_rotary(table.self, to_text(id), out.data()) == 0) return std::nullopt;
  return out;
}
inline bool set_rotary_origin(const Service<ig_work_offset_1>& service, std::string_view id, const Angles& to) {
  const ig_work_offset_1& table = *service.operator->();
  return detail::has_rotary(table) && table.set_rotary(table.self, to_text(id), to.data()) != 0;
}

/// A, B and C of a code that sets coordinates, where the machine has the axis; others are said.
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
