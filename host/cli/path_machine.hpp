/// The machine's rotary axes as a picture needs them: where the tip of the tool is in the workpiece, and which tables
/// turn it. Asks the service isogloss.machine-kinematics/1.
#pragma once

#include "isogloss.h"
#include "tool_path.hpp"

namespace isogloss::cli {

class PathMachine {
 public:
  PathMachine() = default;
  explicit PathMachine(const Chain* chain);
  bool is_known() const { return service_ != nullptr; }
  /// The tip of a tool of this length; without rotary axes the tool lies along Z.
  Point tip(const Point& machine, const Point& angles, double length) const;
  /// The unit vector from the tip to the holder, as the workpiece sees it.
  Point tool_axis(const Point& angles) const;
  PathKinematics describe() const;

 private:
  std::array<double, 16> pivot(const Point& angles) const;
  const ig_machine_kinematics_1* service_ = nullptr;
};

}  // namespace isogloss::cli
