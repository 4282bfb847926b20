/// The spindle in a cycle for holes that turns it itself.
#pragma once

#include <isogloss/cnc/cycle_spindle.hpp>

namespace heidenhain {

/// A member of each syntax of such a cycle.
class HoleSpindle : public ig::cnc::CycleSpindle {
 public:
  using CycleSpindle::turns_ccw;
  bool turns(const ig::Block& b) const { return b.is(in_force_, name(ig::Spindle::cw)) || turns_ccw(b); }
  static ig::Spindle other(ig::Spindle direction) {
    return direction == ig::Spindle::cw ? ig::Spindle::ccw : ig::Spindle::cw;
  }

  /// Before the first step of a cycle that leaves the spindle turning as `last`: begin(), and `last` is in force also
  /// where no block has set a direction.
  void leave(ig::Block& b, const ig::CompoundMotion& motion, ig::Spindle last) const {
    const bool was_set = b.has(in_force_);
    begin(b, motion, last);
    if (!was_set) b.amend(in_force_, name(last));
  }

 private:
  ig::Out<ig::Symbol> in_force_{"SpindleSpeed.Direction"};
};

}  // namespace heidenhain
