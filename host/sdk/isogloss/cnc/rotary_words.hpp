/// A, B and C of a block or of a code that moves: whether the machine has the axis, where it stands, and what the steps
/// of a compound motion do with it. Degrees.
#pragma once

#include "isogloss/sdk.hpp"

#include "isogloss/cnc/rotary_axis.hpp"

namespace ig::cnc {

inline const Diagnostics rotary_words_diagnostics{
    diagnostic(IG_ERROR, "ISO-0401", "{0}: the machine has no such axis, so the word moves nothing",
               "The rows of MachineAxes (--machine FILE), or the parameters of the control, define the axes of the "
               "machine. The word is not executed; the other words of its block are.",
               "G01 B30. F100"),
    diagnostic(IG_NOTE, "ISO-0402", "the machine declares no rotary axes: A, B and C turn without limits",
               "Each of them is assumed to turn without end and to take the shortest way to a position. Reported "
               "once per run. Give --machine FILE with a MachineAxes row for each axis.",
               "G00 A90."),
    diagnostic(IG_ERROR, "ISO-0404", "{0} {1}: this angle is too large for a rotary axis, so the axis does not move",
               "Angles up to a thousand million degrees are supported.", "G00 A1e10"),
};

/// What to do with A, B and C on a machine that declares no rotary axis.
enum class Undeclared { accept, refuse };

/// A member of each syntax that moves rotary axes.
class RotaryWords {
 public:
  const RotaryAxes& axes() const { return axes_; }

  /// True when the axis can go to the angle. False, with a diagnostic at `word`, for an axis that the machine does not
  /// have (ISO-0401) and for an angle of 1e9 degrees or more (ISO-0404). Reports ISO-0402, once a run, where the
  /// machine declares no rotary axis at all.
  bool accept(Block& b, std::size_t axis, double angle, ig_field word) const {
    const bool is_there = axes_.any() ? axes_.has(axis) : undeclared_ == Undeclared::accept;
    if (!is_there) {
      b.report(diag("ISO-0401"), Where::word(word), rotary_names.substr(axis, 1));
      return false;
    }
    if (!(std::fabs(angle) < detail::countable_deg)) {
      b.report(diag("ISO-0404"), Where::word(word), rotary_names.substr(axis, 1), angle);
      return false;
    }
    if (!axes_.any() && !b.is_raised(assumed_)) {
      b.raise(assumed_);
      b.report(diag("ISO-0402"), Where::word(word));
    }
    return true;
  }

 private:
  RotaryAxes axes_;
  Choice<Undeclared> undeclared_{
      "undeclared-axes", "accept|refuse", "accept",
      "A, B and C of a machine that declares no rotary axis: accepted, by the shortest way, or refused."};
  Signal assumed_{"RotaryAxes.~Assumed", read | write, Life::modal};
};

/// The angles at which the rotary axes are: MachineCoordinate.A, B and C.
class RotaryPosition {
 public:
  explicit RotaryPosition(Access access)
      : ids_{Field<double>("MachineCoordinate.A", access).id(), Field<double>("MachineCoordinate.B", access).id(),
             Field<double>("MachineCoordinate.C", access).id()} {}

  PartialAngles get(const Block& b) const { return angles_of(b, ids_); }
  std::optional<double> get(const Block& b, std::size_t axis) const {
    ig_value v;
    return b.get(ids_[axis], v) ? std::optional(v.number) : std::nullopt;
  }
  /// A bit for each axis that was written in this block.
  std::uint32_t fresh(const Block& b) const { return b.fresh_many(ids_.data(), 3); }
  void set(Block& b, std::size_t axis, double angle) const { b.set(ids_[axis], angle); }
  void set(Block& b, const PartialAngles& to) const { set_angles(b, ids_, to); }

 private:
  std::array<ig_field, 3> ids_;
};

/// A, B and C in the steps of CompoundMotion. A step without them leaves the axes where they are.
class RotarySteps {
 public:
  std::uint32_t count(const Block& b) const { return b.count(ids_[0]); }
  PartialAngles get(const Block& b, std::uint32_t step) const {
    ig_value v[3];
    PartialAngles out{b.record(step, ids_.data(), 3, v), {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (out.has(axis)) out.value[axis] = v[axis].number;
    return out;
  }
  void set(Block& b, std::uint32_t step, const PartialAngles& to) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ig_value v{.number = to.value[axis]};
      if (to.has(axis)) b.set_record(step, &ids_[axis], 1, &v);
    }
  }
  /// Writes into the step that was appended last.
  void set_last(Block& b, const PartialAngles& to) const {
    if (to.mask != 0) set(b, count(b) - 1, to);
  }
  /// True when the step moves the axes; false for a dwell, for example.
  bool is_move(const Block& b, std::uint32_t step) const {
    ig_value unused;
    return b.record(step, &x_, 1, &unused) != 0;
  }

 private:
  static ig_field item(const char* path, ig_type type, std::uint32_t access) {
    return ig::detail::declare_field({{"CompoundMotion.Items[].", path}, type, access});
  }
  static constexpr std::uint32_t both = IG_READ | IG_WRITE;

  ig_field x_ = item("MachineCoordinate.X", IG_NUMBER, IG_READ);
  std::array<ig_field, 3> ids_{item("MachineCoordinate.A", IG_NUMBER, both),
                               item("MachineCoordinate.B", IG_NUMBER, both),
                               item("MachineCoordinate.C", IG_NUMBER, both)};
};

}  // namespace ig::cnc
