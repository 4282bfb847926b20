/// The angles of the rotary axes that give the tool a direction, and the choice between several (Fanuc 30i manuals,
/// "Tool axis direction control"). Angles in degrees of the machine.
#pragma once

#include "isogloss/cnc/tool_kinematics.hpp"

namespace ig::cnc {

/// Which pair of angles is chosen where several give the tool its direction.
enum class SolutionChoice { min_first, min_sum, min_max, positive, negative };

inline constexpr const char* solution_choices = "min-first|min-sum|min-max|positive|negative";

struct RotaryCandidates {
  std::array<Angles, 2> angles{};
  std::size_t count = 0;
  bool is_reachable = false;  ///< some angles give the direction, inside the limits or not
};

/// The angles for a direction of the tool: both solutions, each axis in the nearest turn that is inside its travel.
class RotarySolver {
 public:
  /// Condition on an axis: its angle is 0 or has this sign; with sign 0 every angle is allowed.
  struct Sign {
    std::size_t axis;
    int sign;
  };

  /// `direction` points from the tip to the holder. Solutions outside the travel are left out; is_reachable tells the
  /// two reasons for none apart.
  RotaryCandidates candidates(const ToolKinematics& machine, const Vec3& direction, const Angles& present,
                              const Sign& wanted = {0, 0}) const {
    std::array<ig_rotary_solution, 2> found{};
    const std::size_t n = machine.solve(direction, present, found);
    RotaryCandidates out;
    out.is_reachable = n != 0;
    for (std::size_t i = 0; i < n; ++i) {
      Angles angles = present;
      bool is_inside = true;
      for (std::size_t k = 0; k < machine.count(); ++k) {
        const std::size_t axis = machine.axis(k);
        if ((found[i].free >> axis & 1u) == 0)
          angles[axis] =
              nearest_turn_inside(present[axis], found[i].angles[axis], axes_.travel(axis), HalfTurn::positive);
        if (axis == wanted.axis && wanted.sign != 0) angles[axis] = turn_with(wanted, angles[axis]);
        is_inside = is_inside && axes_.travel(axis).holds(angles[axis]);
      }
      if (is_inside) out.angles[out.count++] = angles;
    }
    return out;
  }

  static Sign sign_of(const ToolKinematics& machine, SolutionChoice choice) {
    return {machine.axis(0), choice == SolutionChoice::positive ? 1 : choice == SolutionChoice::negative ? -1 : 0};
  }

  /// True when the angle has the wanted sign. On an axis without limits the angle between -180 and 180 decides, and
  /// half a turn has both signs.
  bool has_sign(const Sign& wanted, double angle) const {
    const AngleRange& travel = axes_.travel(wanted.axis);
    const bool is_limited = std::isfinite(travel.minimum) || std::isfinite(travel.maximum);
    const double named = is_limited ? angle : std::remainder(angle, 360.0);
    return named * wanted.sign >= -same_angle_deg || (!is_limited && std::fabs(named) >= 180 - same_angle_deg);
  }

  /// The best solution in the order of the choice; nothing where the choice rules out all of them.
  std::optional<Angles> choose(const ToolKinematics& machine, const RotaryCandidates& from, const Angles& present,
                               SolutionChoice choice) const {
    const Sign wanted = sign_of(machine, choice);
    std::optional<Angles> best;
    for (std::size_t i = 0; i < from.count; ++i) {
      if (!has_sign(wanted, from.angles[i][wanted.axis])) continue;
      if (!best || comes_first(machine, from.angles[i], *best, present, choice)) best = from.angles[i];
    }
    return best;
  }

  const RotaryAxes& axes() const { return axes_; }

 private:
  /// The nearest turn of the angle that is inside the travel and has the sign; the angle itself where there is none.
  double turn_with(const Sign& wanted, double angle) const {
    for (const double turns : {0.0, 360.0, -360.0, 720.0, -720.0})
      if (has_sign(wanted, angle + turns) && axes_.travel(wanted.axis).holds(angle + turns)) return angle + turns;
    return angle;
  }

  static bool comes_first(const ToolKinematics& machine, const Angles& a, const Angles& b, const Angles& present,
                          SolutionChoice choice) {
    const auto key = [&](const Angles& angles) {
      std::array<double, 2> way{}, from_zero{};
      for (std::size_t k = 0; k < machine.count(); ++k) {
        const std::size_t axis = machine.axis(k);
        way[k] = std::fabs(angles[axis] - present[axis]);
        from_zero[k] = std::fabs(std::remainder(angles[axis], 360.0));
      }
      // Fanuc compares the table before the head.
      const std::size_t first = machine.is_mixed() && machine.is_table(1) ? 1 : 0, second = 1 - first;
      const double sum = way[0] + way[1], longest = std::fmax(way[0], way[1]);
      const double before = choice == SolutionChoice::min_sum   ? sum
                            : choice == SolutionChoice::min_max ? longest
                                                                : way[first];
      const double master = std::remainder(angles[machine.axis(0)], 360.0);
      const bool is_negative = master < 0 && master > -180 + same_angle_deg;  // half a turn is positive, too
      return std::array<double, 6>{before,           way[first],        way[second],
                                   from_zero[first], from_zero[second], is_negative ? 1.0 : 0.0};
    };
    const auto ka = key(a), kb = key(b);
    for (std::size_t i = 0; i < ka.size(); ++i)
      if (std::fabs(ka[i] - kb[i]) > same_angle_deg) return ka[i] < kb[i];
    return false;
  }

  RotaryAxes axes_;
};

}  // namespace ig::cnc
