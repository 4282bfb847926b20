/// A move that leads the tip of the tool while the rotary axes turn: what it demands of the machine's axes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "export/motion_reader.hpp"
#include "isogloss.h"

namespace isogloss {

/// The tip goes straight in the workpiece and the rotary axes turn evenly; the slides follow from the kinematics. The
/// place in the move runs from 0 to 1.
class LedMove {
 public:
  /// `length` is that of the tool, from the gauge point to the point that is led.
  LedMove(const ig_machine_kinematics_1& kinematics, const Move& move, double length)
      : kinematics_(kinematics), length_(length) {
    constexpr std::size_t with_speeds = offsetof(ig_machine_kinematics_1, axis_speeds) + sizeof kinematics.axis_speeds;
    if (kinematics.struct_size < with_speeds || kinematics.axis_speeds == nullptr) return;
    if (!move.from.has_xyz() || !move.machine.has_xyz()) return;
    for (unsigned i = 0; i < 3; ++i) {
      angles_[i] = move.from.has(i + 3) ? move.from.at[i + 3] : 0;
      turning_[i] = (move.machine.has(i + 3) ? move.machine.at[i + 3] : angles_[i]) - angles_[i];
    }
    double end[3], end_angles[3];
    for (unsigned i = 0; i < 3; ++i) end_angles[i] = angles_[i] + turning_[i];
    is_known_ = tip_of(move.from.at, angles_, tip_) && tip_of(move.machine.at, end_angles, end);
    for (unsigned i = 0; is_known_ && i < 3; ++i) way_[i] = end[i] - tip_[i];
  }

  struct Time {
    double seconds = 0;
    bool is_known = false;
    bool is_slowed = false;  ///< an axis is slower than the feed somewhere
  };

  /// By a feed that takes `feed_seconds`, where no axis goes faster than its rate (0: not known).
  Time time(double feed_seconds, const double (&per_second)[6]) const {
    Time out{0, is_known_, false};
    const double turn = std::max({std::abs(turning_[0]), std::abs(turning_[1]), std::abs(turning_[2])});
    constexpr double step_deg = 2, most = 512;
    const int steps = static_cast<int>(std::clamp(std::ceil(turn / step_deg), 1.0, most));
    const auto at = [&](int half_step) {
      const double least = least_seconds(half_step / (2.0 * steps), per_second, out.is_known);
      out.is_slowed = out.is_slowed || least > feed_seconds * (1 + 1e-9);
      return std::max(least, feed_seconds);
    };
    double before = is_known_ ? at(0) : 0;
    for (int i = 0; out.is_known && i < steps; ++i) {  // Simpson's rule
      const double middle = at(2 * i + 1), after = at(2 * i + 2);
      out.seconds += (before + 4 * middle + after) / (6 * steps);
      before = after;
    }
    return out;
  }

 private:
  /// The time of the whole move if the axes moved as at one place of it, each no faster than its rate.
  double least_seconds(double place, const double (&per_second)[6], bool& is_known) const {
    double angles[3], tip[3], slides[3];
    for (unsigned i = 0; i < 3; ++i) {
      angles[i] = angles_[i] + place * turning_[i];
      tip[i] = tip_[i] + place * way_[i];
    }
    if (kinematics_.axis_speeds(kinematics_.self, angles, turning_, tip, length_, way_, slides) == 0) is_known = false;
    double longest = 0;
    for (unsigned i = 0; is_known && i < 3; ++i) {
      if (per_second[i] > 0) longest = std::max(longest, std::abs(slides[i]) / per_second[i]);
      if (per_second[i + 3] > 0) longest = std::max(longest, std::abs(turning_[i]) / per_second[i + 3]);
    }
    return longest;
  }

  /// The position of the tip in the workpiece for these positions of the slides and rotary axes.
  bool tip_of(const double* machine, const double (&angles)[3], double (&tip)[3]) const {
    double pivot[16], axis[3];
    if (kinematics_.pivot(kinematics_.self, angles, pivot) == 0) return false;
    if (kinematics_.tool_axis(kinematics_.self, angles, axis) == 0) return false;
    for (int i = 0; i < 3; ++i) {
      tip[i] = -length_ * axis[i];
      for (int j = 0; j < 3; ++j) tip[i] += (machine[j] - pivot[12 + j]) * pivot[4 * i + j];
    }
    return std::isfinite(tip[0] + tip[1] + tip[2]);
  }

  const ig_machine_kinematics_1& kinematics_;
  double length_;
  double angles_[3] = {}, turning_[3] = {}, tip_[3] = {}, way_[3] = {};
  bool is_known_ = false;
};

}  // namespace isogloss
