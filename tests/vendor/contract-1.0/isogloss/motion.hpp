/// Motion verbs: a canned cycle's build() reads like the controller's manual.
#pragma once

#include "isogloss/block.hpp"

namespace ig {

enum class Spindle { cw, ccw, stop };

namespace detail {

/// A step's field, written.
inline ig_field declare_item(std::string_view path, ig_type type) {
  return declare_field({{"CompoundMotion.Items[].", path}, type, IG_WRITE});
}

}  // namespace detail

/// CompoundMotion: the steps that one block makes. `end` is where the tool stands after them.
class CompoundMotion {
 public:
  /// The block now moves by steps; `term` is the code that does so.
  void begin(Block& b, Symbol term) const { b.set(term_, term); }

  void rapid_to(Block& b, const Vec3& p) const {
    const ig_value v[] = {{.number = p.x}, {.number = p.y}, {.number = p.z}, symbol(linear_), boolean(true)};
    append(b, rapid_, v);
  }
  /// The same where the machine point does not follow from the program point (reference positions).
  void rapid_to(Block& b, const Vec3& program, const Vec3& machine) const {
    const ig_value v[] = {{.number = program.x}, {.number = program.y}, {.number = program.z}, symbol(linear_),
                          boolean(true),         {.number = machine.x}, {.number = machine.y}, {.number = machine.z}};
    append(b, machine_rapid_, v);
  }
  /// feed in mm/s; 0: no feed is in force.
  void feed_to(Block& b, const Vec3& p, double feed_mmds) const {
    const ig_value v[] = {{.number = p.x}, {.number = p.y}, {.number = p.z}, symbol(linear_), {.number = feed_mmds}};
    b.host()->append(b.raw(), feed_.data(), feed_mmds > 0 ? 5 : 4, v);
  }
  void dwell(Block& b, double seconds) const {
    const ig_value v{.number = seconds};
    b.host()->append(b.raw(), &dwell_, 1, &v);
  }
  void spindle(Block& b, Spindle direction) const {
    const ig_value v = symbol(direction == Spindle::cw ? cw_ : direction == Spindle::ccw ? ccw_ : stop_);
    b.host()->append(b.raw(), &spindle_, 1, &v);
  }
  /// An oriented stop; angle in degrees.
  void orient(Block& b, double angle) const {
    const ig_value v{.number = angle};
    b.host()->append(b.raw(), &orient_, 1, &v);
  }

  const Out<Symbol>& term() const { return term_; }

 private:
  static ig_value symbol(Symbol s) { return detail::ValueOf<Symbol>::write(s); }
  static ig_value boolean(bool v) { return detail::ValueOf<bool>::write(v); }
  template <std::size_t N>
  void append(Block& b, const std::array<ig_field, N>& fields, const ig_value* v) const {
    b.host()->append(b.raw(), fields.data(), N, v);
  }

  Out<Symbol> term_{"CompoundMotion.Term"};
  ig_field x_ = detail::declare_item("ProgramXyz.X", IG_NUMBER);
  ig_field y_ = detail::declare_item("ProgramXyz.Y", IG_NUMBER);
  ig_field z_ = detail::declare_item("ProgramXyz.Z", IG_NUMBER);
  ig_field form_ = detail::declare_item("MotionEvent.Form", IG_SYMBOL);
  ig_field is_rapid_ = detail::declare_item("MotionEvent.IsRapid", IG_BOOLEAN);
  ig_field feedrate_ = detail::declare_item("MotionEvent.Feedrate_mmds", IG_NUMBER);
  ig_field mx_ = detail::declare_item("MachineCoordinate.X", IG_NUMBER);
  ig_field my_ = detail::declare_item("MachineCoordinate.Y", IG_NUMBER);
  ig_field mz_ = detail::declare_item("MachineCoordinate.Z", IG_NUMBER);
  ig_field dwell_ = detail::declare_item("Dwell.Time", IG_NUMBER);
  ig_field spindle_ = detail::declare_item("SpindleControl.Direction", IG_SYMBOL);
  ig_field orient_ = detail::declare_item("SpindleOrientation.Angle_deg", IG_NUMBER);
  std::array<ig_field, 5> rapid_{x_, y_, z_, form_, is_rapid_};
  std::array<ig_field, 8> machine_rapid_{x_, y_, z_, form_, is_rapid_, mx_, my_, mz_};
  std::array<ig_field, 5> feed_{x_, y_, z_, form_, feedrate_};
  Name linear_{"McLinear"}, cw_{"CW"}, ccw_{"CCW"}, stop_{"STOP"};
};

/// Steps of a CompoundMotion that the operator makes by hand: the control waits until they are done.
class ManualMotion {
 public:
  void rapid_to(Block& b, const Vec3& p) const {
    const ig_value v[] = {{.number = p.x},
                          {.number = p.y},
                          {.number = p.z},
                          detail::ValueOf<Symbol>::write(linear_),
                          detail::ValueOf<bool>::write(true),
                          detail::ValueOf<bool>::write(true)};
    b.host()->append(b.raw(), fields_.data(), static_cast<std::uint32_t>(fields_.size()), v);
  }

 private:
  std::array<ig_field, 6> fields_{detail::declare_item("ProgramXyz.X", IG_NUMBER),
                                  detail::declare_item("ProgramXyz.Y", IG_NUMBER),
                                  detail::declare_item("ProgramXyz.Z", IG_NUMBER),
                                  detail::declare_item("MotionEvent.Form", IG_SYMBOL),
                                  detail::declare_item("MotionEvent.IsRapid", IG_BOOLEAN),
                                  detail::declare_item("MotionEvent.IsManual", IG_BOOLEAN)};
  Name linear_{"McLinear"};
};

}  // namespace ig
