/// The spindle around a cycle that turns it: an M code of the same block acts before the first hole, and the direction
/// that the cycle ends with is in force for the blocks after it.
#pragma once

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// A member of each cycle syntax that turns, stops or reverses the spindle.
class CycleSpindle {
 public:
  /// Makes M03, M04 or M05 of this block the first step of the motion, unless the order of events within a block gives
  /// the same result (a start acts before the steps, a stop after them). Then `last` becomes the direction in force.
  void begin(Block& b, const CompoundMotion& motion, Spindle last) const {
    const auto now = b.get(direction_);
    if (!now) return;
    const bool is_programmed_here = b.is_fresh(direction_);
    const bool stays = *now == name(last);
    if (is_programmed_here && (!stays || *now == stop_))
      motion.spindle(b, *now == cw_ ? Spindle::cw : *now == ccw_ ? Spindle::ccw : Spindle::stop);
    if (stays) return;
    if (is_programmed_here) b.erase(direction_);  // the step holds it now
    b.amend(direction_, name(last));
  }

  /// The direction of the spindle when the cycle begins; empty where no block has set one.
  std::optional<Symbol> direction(const Block& b) const { return b.get(direction_); }
  Symbol name(Spindle direction) const {
    return direction == Spindle::cw ? cw_ : direction == Spindle::ccw ? ccw_ : stop_;
  }

 protected:
  bool turns_ccw(const Block& b) const { return b.is(direction_, ccw_); }

 private:
  Out<Symbol> direction_{"SpindleSpeed.Direction"};
  Name cw_{"CW"}, ccw_{"CCW"}, stop_{"STOP"};
};

}  // namespace ig::cnc
