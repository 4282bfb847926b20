/// The shift of fine boring (G76) and back boring (G87): with the spindle stopped at its angle the bar moves sideways,
/// so that its tip leaves the wall and the bar may pass through the bore.
#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include <isogloss/cnc/canned_cycle.hpp>

namespace iso {

using namespace ig::cnc;

/// Directions named as in G17. In the other planes X stands for the plane's first axis and Y for its second (Fanuc
/// parameter 5101 bits 4 and 5: G18 Z X, G19 Y Z).
enum class ShiftDirection { plus_x, minus_x, plus_y, minus_y, parameter };

constexpr ig::Vec3 shift_direction(ShiftDirection direction, const PlaneAxes& plane) {
  const bool is_second = direction == ShiftDirection::plus_y || direction == ShiftDirection::minus_y;
  const bool is_minus = direction == ShiftDirection::minus_x || direction == ShiftDirection::minus_y;
  ig::Vec3 unit;
  unit[is_second ? plane.second : plane.first] = is_minus ? -1 : 1;
  return unit;
}

/// The direction from a machine parameter: 1 X, 2 Y, 3 Z, negative for the opposite direction. Nothing where it names
/// no axis, or the axis along which the tool bores.
constexpr std::optional<ig::Vec3> shift_direction(double signed_axis, const PlaneAxes& plane) {
  const double number = signed_axis < 0 ? -signed_axis : signed_axis;
  for (const std::size_t axis : {plane.first, plane.second}) {
    if (number != static_cast<double>(axis + 1)) continue;
    ig::Vec3 unit;
    unit[axis] = signed_axis < 0 ? -1 : 1;
    return unit;
  }
  return std::nullopt;
}

/// The hole with the bar's position off the centre in place of the hole's own.
inline CycleHole shifted(CycleHole hole, const ig::Vec3& shift) {
  hole.position = hole.position + shift;
  return hole;
}

/// A member of the two syntaxes: their options, and the vector from the centre of the bore to the shifted bar.
class ToolShift {
 public:
  struct Shift {
    ig::Vec3 vector;  ///< program coordinates
    bool is_feed;     ///< moved by feed, not by rapid
  };

  /// The shift of this block. Reports where there is none, and where it differs from what the block programs.
  Shift of(ig::Block& b, const CycleRun& run) const { return is_by_q(run) ? by_q(b, run) : by_vector(b, run); }
  /// The letters of the words that give the shift of this call: I J without the component along the tool axis.
  std::string_view used_words(const CycleRun& run) const {
    if (is_by_q(run)) return "Q";
    return run.plane.tool == 2 ? "IJ" : run.plane.tool == 1 ? "I" : "J";
  }

  /// Moves the bar sideways at `feed`, in mm/s, or by rapid, as the words of the shift say.
  static void move_aside(ig::Block& b, const ig::CompoundMotion& motion, const Shift& shift, const ig::Vec3& to,
                         double feed) {
    shift.is_feed ? motion.feed_to(b, to, feed) : motion.rapid_to(b, to);
  }
  /// The way out of the bore from `level`: the spindle stops at its angle, the bar leaves the wall, retracts, comes
  /// back to the centre above the bore, and the spindle turns again.
  void retract(ig::Block& b, const ig::CompoundMotion& motion, const CycleHole& bore, const Shift& shift, double level,
               double return_level, double feed, ig::Spindle start) const {
    const CycleHole aside = shifted(bore, shift.vector);
    motion.orient(b, angle_);
    move_aside(b, motion, shift, aside.at(level), feed);
    motion.rapid_to(b, aside.at(return_level));
    move_aside(b, motion, shift, bore.at(return_level), feed);
    motion.spindle(b, start);
  }

  /// The angle at which the spindle stops, in degrees.
  double angle() const { return angle_; }

 private:
  enum class Words { q, ij, q_or_ij };
  enum class FrameOfShift { program, machine };

  bool is_by_q(const CycleRun& run) const {
    const bool has_vector = run.words.get_or(CycleWords::I, 0) != 0 || run.words.get_or(CycleWords::J, 0) != 0;
    const bool has_q = run.words.get_or(CycleWords::Q, 0) != 0;
    return words_ == Words::q || (words_ == Words::q_or_ij && (has_q || !has_vector));
  }

  Shift by_q(ig::Block& b, const CycleRun& run) const {
    const double q = run.words.get_or(CycleWords::Q, 0);
    if (q == 0) {
      report_none(b, run, "Q");
      return {{}, false};
    }
    if (q < 0) b.report(ig::diag("ISO-0343"), ig::Where::block(), b.text(run.code), q);
    if (b.is_raised(q_of_another_use_))
      b.report(ig::diag("ISO-0344"), ig::Where::block(), b.text(run.code), q, std::string_view("shift"));
    return {in_program(b, run.plane, std::fabs(q) * unit(run.plane)), false};
  }

  /// The components along the axes of the plane. K is the number of holes, so there is no component along Z.
  Shift by_vector(ig::Block& b, const CycleRun& run) const {
    ig::Vec3 vector{run.words.get_or(CycleWords::I, 0), run.words.get_or(CycleWords::J, 0), 0};
    vector[run.plane.tool] = 0;
    if (vector == ig::Vec3{}) report_none(b, run, "I and J");
    return {in_program(b, run.plane, vector), words_ == Words::ij};
  }

  ig::Vec3 unit(const PlaneAxes& plane) const {
    if (direction_ != ShiftDirection::parameter) return shift_direction(direction_, plane);
    static constexpr std::string_view keys[] = {"ShiftDirectionX", "ShiftDirectionY", "ShiftDirectionZ"};
    const auto by_machine = shift_direction(config_.number(keys[plane.tool]).value_or(0), plane);
    return by_machine ? *by_machine : shift_direction(ShiftDirection::plus_x, plane);
  }

  /// The shift in program coordinates: the bar points the same way however the program is rotated. Where the machine's
  /// direction would leave the plane (a tilted head), the program's axes are used.
  ig::Vec3 in_program(ig::Block& b, const PlaneAxes& plane, const ig::Vec3& shift) const {
    if (frame_ == FrameOfShift::program) return shift;
    const auto origin = b.to_machine({});
    if (!origin) return shift;
    const auto to = b.to_program(*origin + shift);
    if (!to || rounded((*to)[plane.tool]) != 0) return shift;
    ig::Vec3 turned = rounded(*to);
    turned[plane.tool] = 0;
    return turned;
  }

  static void report_none(ig::Block& b, const CycleRun& run, std::string_view words) {
    b.report(ig::diag("ISO-0342"), ig::Where::block(), b.text(run.code), words);
  }

  ig::Choice<ShiftDirection> direction_{"shift-direction", "+X|-X|+Y|-Y|parameter", "+X",
                                        "Where Q shifts the bar, in terms of G17."};
  ig::Choice<Words> words_{
      "shift-words", "q|ij|q-or-ij", "q",
      "The words of the shift: Q, by rapid; the vector I J, by feed; Q or, without Q, I J, by rapid."};
  ig::Choice<FrameOfShift> frame_{"shift-frame", "program|machine", "program", "Whose axes the shift follows."};
  ig::NumberOption angle_{"angle", "0", {0, 360}, "deg", "Where the spindle stops."};
  ig::Config config_{"isogloss.canned-cycle/1", ig::Need::optional, "The machine's shift direction."};
  ig::Signal q_of_another_use_{"CannedCycle.~QOfAnotherUse", ig::read};
};

}  // namespace iso
