/// Where the rotary axes stand upright on a plane, and which of the two ways there is taken.
#pragma once

#include "tool_kinematics.hpp"

namespace heidenhain {

/// A member of the syntax that positions them.
class PlanePositioning {
 public:
  explicit operator bool() const { return bool(machine_); }
  const iso::ToolKinematics& machine() const { return machine_; }

  iso::Angles present(const ig::Block& b) const {
    iso::Angles now{};
    for (std::size_t axis = 0; axis < 3; ++axis) now[axis] = b.get_or(present_[axis], 0.0);
    return now;
  }

  /// Inside the travel; nothing where no position is, or none with that sign of the master axis (0: any).
  std::optional<iso::Angles> choose(const ig::Vec3& normal, const iso::Angles& now, int sequence) const {
    const iso::RotaryCandidates found = solver_.candidates(machine_, normal, now);
    std::optional<iso::Angles> best;
    double best_way = 0;
    for (std::size_t i = 0; i < found.count; ++i) {
      constexpr double same = 1e-6;
      const double angle = std::remainder(found.angles[i][master()], 360.0) * sequence;
      if (angle < -same) continue;
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
  bool are_inside(const iso::Angles& angles) const {
    for (std::size_t k = 0; k < machine_.count(); ++k)
      if (!solver_.axes().travel(machine_.axis(k)).holds(angles[machine_.axis(k)])) return false;
    return true;
  }

 private:
  enum class Choice { sum, farthest };

  /// SEQ is the sign of the master axis: the first one counted from the tool, or the last one counted from the table.
  std::size_t master() const {
    const bool second_is_head = machine_.count() == 2 && !machine_.is_table(1);
    return machine_.axis(second_is_head ? 1 : 0);
  }

  iso::ToolKinematics machine_;
  iso::RotarySolver solver_;
  std::array<ig::Previous<double>, 3> present_{ig::Previous<double>{"MachineCoordinate.A"},
                                               ig::Previous<double>{"MachineCoordinate.B"},
                                               ig::Previous<double>{"MachineCoordinate.C"}};
  ig::Choice<Choice> choice_{"choice", "sum|farthest", "sum",
                             "Which solution is taken without SEQ: the shorter way of both axes together, or of the "
                             "one that goes farther."};
};

}  // namespace heidenhain
