/// Steps of a compound motion that replace a single move. Program coordinates in mm, feeds in mm/s, angles in degrees.
#pragma once

#include <array>
#include <optional>

#include "isogloss/cnc/rotary_words.hpp"

namespace ig::cnc {

/// Appends steps with the tool's centre in program coordinates; finish() computes the machine coordinates of all of
/// them.
class ToolSteps {
 public:
  /// What a step keeps of the move that it replaces: rapid or feed, and additional whole circles of an arc.
  struct Manner {
    bool is_rapid = false;
    std::optional<double> feed_mmds;
    std::int64_t more_circles = 0;
  };

  void line(Block& b, const Vec3& to, const Manner& manner) const {
    ig_field fields[12];
    ig_value values[12];
    const std::uint32_t n = begin(to, manner, linear_, fields, values);
    b.append(fields, n, values);
  }
  void arc(Block& b, const Vec3& to, const Vec3& center, bool is_ccw, const Manner& manner) const {
    ig_field fields[12];
    ig_value values[12];
    std::uint32_t n = begin(to, manner, arc_, fields, values);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      fields[n] = center_[axis];
      values[n++].number = center[axis];
    }
    fields[n] = is_ccw_;
    values[n++].integer = is_ccw ? 1 : 0;
    fields[n] = circles_;
    values[n++].integer = manner.more_circles;
    b.append(fields, n, values);
  }
  /// The tip goes straight to `to` while the rotary axes turn; the caller gives the machine position at the end.
  void led(Block& b, const Vec3& to, const Vec3& machine, const PartialAngles& rotary, const Manner& manner) const {
    ig_field fields[12];
    ig_value values[12];
    std::uint32_t n = begin(to, manner, led_, fields, values);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      fields[n] = machine_[axis];
      values[n++].number = machine[axis];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!rotary.has(axis)) continue;
      fields[n] = rotary_[axis];
      values[n++].number = rotary.value[axis];
    }
    b.append(fields, n, values);
  }
  /// Computes the machine coordinates of all steps and writes the angles of the rotary axes that the block turns into
  /// the last one. Call it once, after at least one step.
  void finish(Block& b, const PartialAngles& rotary) const {
    b.map_records(program_.data(), machine_.data());
    const std::uint32_t last = b.count(program_[0]) - 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ig_value v{.number = rotary.value[axis]};
      if (rotary.has(axis)) b.set_record(last, &rotary_[axis], 1, &v);
    }
  }

 private:
  std::uint32_t begin(const Vec3& to, const Manner& manner, Symbol form, ig_field* fields, ig_value* values) const {
    std::uint32_t n = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      fields[n] = program_[axis];
      values[n++].number = to[axis];
    }
    fields[n] = form_;
    values[n++].symbol = form.id;
    if (manner.is_rapid) {
      fields[n] = is_rapid_;
      values[n++].integer = 1;
    } else if (manner.feed_mmds) {
      fields[n] = feedrate_;
      values[n++].number = *manner.feed_mmds;
    }
    return n;
  }
  static std::array<ig_field, 3> triple(std::string_view section, std::string_view axes) {
    std::array<ig_field, 3> ids{};
    for (std::size_t i = 0; i < 3; ++i)
      ids[i] = ig::detail::declare_field(
          {{"CompoundMotion.Items[].", section, ".", axes.substr(i, 1)}, IG_NUMBER, IG_WRITE});
    return ids;
  }

  std::array<ig_field, 3> program_ = triple("ProgramXyz", "XYZ");
  std::array<ig_field, 3> machine_ = triple("MachineCoordinate", "XYZ");
  std::array<ig_field, 3> rotary_ = triple("MachineCoordinate", "ABC");
  std::array<ig_field, 3> center_ = triple("MotionEvent.ArcCenter", "XYZ");
  ig_field form_ = ig::detail::declare_item("MotionEvent.Form", IG_SYMBOL);
  ig_field is_rapid_ = ig::detail::declare_item("MotionEvent.IsRapid", IG_BOOLEAN);
  ig_field feedrate_ = ig::detail::declare_item("MotionEvent.Feedrate_mmds", IG_NUMBER);
  ig_field is_ccw_ = ig::detail::declare_item("MotionEvent.IsCcw", IG_BOOLEAN);
  ig_field circles_ = ig::detail::declare_item("MotionEvent.AdditionalCircleNum", IG_INTEGER);
  Name linear_{"McLinear"}, led_{"ClLinear"}, arc_{"McArc"};
};

}  // namespace ig::cnc
