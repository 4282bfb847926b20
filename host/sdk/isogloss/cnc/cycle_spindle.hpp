/// The spindle around a cycle that turns it itself: an M code of the same block acts before the first hole, and what
/// the cycle leaves behind is the direction in force for the blocks after it.
#pragma once

#include "isogloss/sdk.hpp"

namespace ig::cnc {

class CycleSpindle {
 public:
  /// M03, M04, M05 (M29) of this block, as a step, unless the order of events of a block says the same: a start comes
  /// before the steps, but a stop after them. Then the direction in force is `last`.
  void begin(Block& b, const CompoundMotion& motion, Spindle last) const {
    const auto now = b.get(direction_);
    if (!now) return;
    const bool is_programmed_here = b.is_fresh(direction_);
    const bool stays = *now == name(last);
    if (is_programmed_here && (!stays || *now == stop_))
      motion.spindle(b, *now == cw_ ? Spindle::cw : *now == ccw_ ? Spindle::ccw : Spindle::stop);
    if (stays) return;
    if (is_programmed_here) b.erase(direction_);  // said by the step already
    b.amend(direction_, name(last));
  }

  /// How the spindle turns when the cycle begins; empty when nothing was ever said.
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
