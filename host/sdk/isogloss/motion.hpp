/// The steps of a block that makes several moves. A canned cycle written with them reads like the control's manual.
/// Points in mm, feeds in mm/s, dwells in seconds, angles in degrees.
#pragma once

#include <utility>

#include "isogloss/block.hpp"

namespace ig {

enum class Spindle { cw, ccw, stop };

namespace detail {

/// Declares a field of a step, to be written.
inline ig_field declare_item(std::string_view path, ig_type type) {
  return declare_field({{"CompoundMotion.Items[].", path}, type, IG_WRITE});
}

}  // namespace detail

/// The section CompoundMotion: the steps of one block, in their order. The syntax itself sets ProgramXyz to the end
/// point.
class CompoundMotion {
 public:
  /// Begins the steps of the block; `term` is the code that makes them.
  void begin(Block& b, Symbol term) const { b.set(term_, term); }

  /// A rapid to a program point.
  void rapid_to(Block& b, const Vec3& p) const {
    const ig_value v[] = {{.number = p.x}, {.number = p.y}, {.number = p.z}, symbol(linear_), boolean(true)};
    append(b, rapid_, v);
  }
  /// A rapid to a machine point that does not follow from the program point through the frame (reference positions).
  void rapid_to(Block& b, const Vec3& program, const Vec3& machine) const {
    const ig_value v[] = {{.number = program.x}, {.number = program.y}, {.number = program.z}, symbol(linear_),
                          boolean(true),         {.number = machine.x}, {.number = machine.y}, {.number = machine.z}};
    append(b, machine_rapid_, v);
  }
  /// A straight move by feed, in mm/s; 0 where no feed is in force, which the caller reports.
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
  /// An oriented spindle stop; `angle` in degrees.
  void orient(Block& b, double angle) const {
    const ig_value v{.number = angle};
    b.host()->append(b.raw(), &orient_, 1, &v);
  }

  const Out<Symbol>& term() const { return term_; }

 private:
  friend class CompoundSteps;

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
  std::array<ig_field, 6> steps_{x_, y_, z_, form_, is_rapid_, feedrate_};
  Name linear_{"McLinear"}, cw_{"CW"}, ccw_{"CCW"}, stop_{"STOP"};
};

/// The steps of a CompoundMotion, handed to the host several at a time, which takes less than one by one: for a block
/// that makes many. All of them are in the block when this object ends, or after flush().
class CompoundSteps {
 public:
  CompoundSteps(Block& b, const CompoundMotion& motion)
      : b_(b), motion_(motion), linear_(CompoundMotion::symbol(motion.linear_)) {}
  CompoundSteps(const CompoundSteps&) = delete;
  CompoundSteps& operator=(const CompoundSteps&) = delete;
  /// Throws what the host throws, std::bad_alloc for instance, as the functions do.
  ~CompoundSteps() noexcept(false) { flush(); }

  void rapid_to(const Vec3& p) { move_to(p, rapid, 0); }
  /// A straight move by feed, in mm/s; 0 where no feed is in force, which the caller reports.
  void feed_to(const Vec3& p, double feed_mmds) { move_to(p, feed_mmds > 0 ? with_feed : without_feed, feed_mmds); }
  void dwell(double seconds) {
    flush();
    motion_.dwell(b_, seconds);
  }
  void spindle(Spindle direction) {
    flush();
    motion_.spindle(b_, direction);
  }
  void flush() {
    // Before the host throws: the end of this object then does no more.
    const std::uint32_t steps = std::exchange(count_, 0);
    if (steps == 0) return;
    const ig_host* const host = b_.host();
    if (host->struct_size >= offsetof(ig_host, append_many) + sizeof host->append_many)
      host->append_many(b_.raw(), motion_.steps_.data(), fields, steps, masks_.data(), values_[0].data());
    else
      append_each(steps);
  }

 private:
  static constexpr std::uint32_t capacity = 16, fields = 6;
  // X, Y, Z and the form, then that it is rapid, then the feed.
  static constexpr std::uint32_t without_feed = 0b001111, rapid = 0b011111, with_feed = 0b101111;

  void move_to(const Vec3& p, std::uint32_t mask, double feed_mmds) {
    if (count_ == capacity) flush();
    std::array<ig_value, fields>& v = values_[count_];
    v[0].number = p.x;
    v[1].number = p.y;
    v[2].number = p.z;
    v[3] = linear_;
    v[4] = CompoundMotion::boolean(true);
    v[5].number = feed_mmds;
    masks_[count_++] = mask;
  }
  /// To a host before contract 1.8.
  void append_each(std::uint32_t steps) {
    for (std::uint32_t i = 0; i < steps; ++i) {
      std::array<ig_value, fields>& v = values_[i];
      const bool is_rapid = masks_[i] == rapid;
      if (!is_rapid) v[4] = v[5];
      b_.host()->append(b_.raw(), (is_rapid ? motion_.rapid_ : motion_.feed_).data(), masks_[i] == without_feed ? 4 : 5,
                        v.data());
    }
  }

  Block& b_;
  const CompoundMotion& motion_;
  const ig_value linear_;
  std::uint32_t count_ = 0;
  // Without values at the start: those that are not used cost nothing.
  std::array<std::uint32_t, capacity> masks_;
  std::array<std::array<ig_value, fields>, capacity> values_;
};

/// Steps of a CompoundMotion that the operator makes by hand; the control waits until they are done.
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
