/// The angles of the rotary axes that set the tool square to a plane, and which of the two solutions is used.
#pragma once

#include <numbers>

#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/rotary_solver.hpp>
#include <isogloss/cnc/units.hpp>

namespace heidenhain {

using namespace ig::cnc;

/// A member of the syntax that positions the axes.
class PlanePositioning {
 public:
  explicit operator bool() const { return bool(machine_); }
  const ToolKinematics& machine() const { return machine_; }

  Angles present(const ig::Block& b) const {
    Angles now{};
    for (std::size_t axis = 0; axis < 3; ++axis) now[axis] = b.get_or(present_[axis], 0.0);
    return now;
  }

  /// A solution inside the travel; nothing where there is none, or none with that sign of the master axis (0: any
  /// sign).
  std::optional<Angles> choose(const ig::Vec3& normal, const Angles& now, int sequence) const {
    const RotarySolver::Sign wanted{master(), sequence};
    const RotaryCandidates found = solver_.candidates(machine_, normal, now, wanted);
    std::optional<Angles> best;
    double best_way = 0;
    for (std::size_t i = 0; i < found.count; ++i) {
      constexpr double same = 1e-6;
      if (!solver_.has_sign(wanted, found.angles[i][master()])) continue;
      double sum = 0, farthest = 0;
      for (std::size_t k = 0; k < machine_.count(); ++k) {
        const double way = std::fabs(found.angles[i][machine_.axis(k)] - now[machine_.axis(k)]);
        sum += way;
        farthest = std::fmax(farthest, way);
      }
      const double way = choice_ == Choice::sum ? sum : farthest;
      const bool is_better =
          !best || way < best_way - same || (way < best_way + same && found.angles[i][master()] > (*best)[master()]);
      if (!is_better) continue;
      best = found.angles[i];
      best_way = way;
    }
    return best;
  }
  /// A table that carries the workpiece and whose axis lies along the tool is free: its angle does not lean the tool.
  /// TABLE ROT turns it until X of a level plane lies along X of the machine, COORD ROT turns it to 0; with a plane
  /// that is not level it does not move.
  Angles with_free_axis(const Angles& upright, const Mat4& plane, const Angles& now, bool turns_table) const {
    const std::size_t last = machine_.count() - 1, axis = machine_.axis(last);
    const auto tool = machine_.tool_axis(upright);
    Angles turned = upright;
    turned[axis] += 90;
    const auto other = machine_.tool_axis(turned);
    if (!machine_.is_table(last) || !tool || !other || dot(*tool, *other) < 1 - same_direction) return upright;
    if (!turns_table && free_axis_ == FreeAxis::stays) return upright;
    double to = 0;
    if (turns_table) {
      if (plane[10] < 1 - same_direction) return upright;
      const auto aligned = aligning_angle(upright, axis, {plane[0], plane[1], plane[2]});
      if (!aligned) return upright;
      to = *aligned;
    }
    Angles out = upright;
    const AngleRange& travel = solver_.axes().travel(axis);
    out[axis] = nearest_turn_inside(now[axis], to, travel, HalfTurn::positive);
    return travel.holds(out[axis]) ? out : upright;
  }
  bool are_inside(const Angles& angles) const {
    for (std::size_t k = 0; k < machine_.count(); ++k)
      if (!solver_.axes().travel(machine_.axis(k)).holds(angles[machine_.axis(k)])) return false;
    return true;
  }

 private:
  enum class Choice { sum, farthest };
  static constexpr double same_direction = 1e-9;  ///< tolerance for the cosine of two equal directions

  /// The table angle that brings the direction `x` of the workpiece along X of the machine.
  std::optional<double> aligning_angle(Angles angles, std::size_t axis, const ig::Vec3& x) const {
    const auto seen = [&](double angle) -> std::optional<ig::Vec3> {
      angles[axis] = angle;
      const auto turn = machine_.pivot(angles);
      if (!turn) return std::nullopt;
      return mapped(at_origin(*turn, {}), x);
    };
    const auto at_zero = seen(0);
    if (!at_zero) return std::nullopt;
    const double way = std::atan2(at_zero->y, at_zero->x) * degrees_per_radian;
    for (const double angle : {way, -way})
      if (const auto there = seen(angle); there && there->x > 1 - same_direction) return rounded(angle);
    return std::nullopt;
  }

  /// SEQ is the sign of the master axis: the first one from the tool, or the last one from the table.
  std::size_t master() const {
    const bool second_is_head = machine_.count() == 2 && !machine_.is_table(1);
    return machine_.axis(second_is_head ? 1 : 0);
  }

  ToolKinematics machine_;
  RotarySolver solver_;
  std::array<ig::Previous<double>, 3> present_{ig::Previous<double>{"MachineCoordinate.A"},
                                               ig::Previous<double>{"MachineCoordinate.B"},
                                               ig::Previous<double>{"MachineCoordinate.C"}};
  ig::Choice<Choice> choice_{"choice", "sum|farthest", "sum",
                             "Which solution is selected without SEQ: the shorter way of both axes together, or of the "
                             "axis that moves farther."};
  enum class FreeAxis { zero, stays };
  ig::Choice<FreeAxis> free_axis_{"free-axis", "zero|stays", "zero",
                                  "Where COORD ROT puts a table that lies square to the tool: at 0 as a TNC 640, or "
                                  "where it stands as an iTNC 530."};
};

}  // namespace heidenhain
