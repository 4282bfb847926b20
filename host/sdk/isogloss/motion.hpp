/// Motion verbs: a canned cycle's build() reads like the controller's manual.
#pragma once

#include "isogloss/block.hpp"

namespace ig {

enum class Spindle { cw, ccw, stop };

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
  static constexpr const char* items = "CompoundMotion.Items[].";
  static ig_field item(std::string_view path, ig_type type) {
    return detail::declare_field({items + std::string(path), type, IG_WRITE});
  }
  static ig_value symbol(Symbol s) { return detail::ValueOf<Symbol>::write(s); }
  static ig_value boolean(bool v) { return detail::ValueOf<bool>::write(v); }
  template <std::size_t N>
  void append(Block& b, const std::array<ig_field, N>& fields, const ig_value* v) const {
    b.host()->append(b.raw(), fields.data(), N, v);
  }

  Out<Symbol> term_{"CompoundMotion.Term"};
  ig_field x_ = item("ProgramXyz.X", IG_NUMBER);
  ig_field y_ = item("ProgramXyz.Y", IG_NUMBER);
  ig_field z_ = item("ProgramXyz.Z", IG_NUMBER);
  ig_field form_ = item("MotionEvent.Form", IG_SYMBOL);
  ig_field is_rapid_ = item("MotionEvent.IsRapid", IG_BOOLEAN);
  ig_field feedrate_ = item("MotionEvent.Feedrate_mmds", IG_NUMBER);
  ig_field mx_ = item("MachineCoordinate.X", IG_NUMBER);
  ig_field my_ = item("MachineCoordinate.Y", IG_NUMBER);
  ig_field mz_ = item("MachineCoordinate.Z", IG_NUMBER);
  ig_field dwell_ = item("Dwell.Time", IG_NUMBER);
  ig_field spindle_ = item("SpindleControl.Direction", IG_SYMBOL);
  ig_field orient_ = item("SpindleOrientation.Angle_deg", IG_NUMBER);
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
  static ig_field item(const char* path, ig_type type) {
    return detail::declare_field({"CompoundMotion.Items[]." + std::string(path), type, IG_WRITE});
  }

  std::array<ig_field, 6> fields_{item("ProgramXyz.X", IG_NUMBER),         item("ProgramXyz.Y", IG_NUMBER),
                                  item("ProgramXyz.Z", IG_NUMBER),         item("MotionEvent.Form", IG_SYMBOL),
                                  item("MotionEvent.IsRapid", IG_BOOLEAN), item("MotionEvent.IsManual", IG_BOOLEAN)};
  Name linear_{"McLinear"};
};

}  // namespace ig
