/// The spindle around a cycle that turns it itself: an M code of the same block acts before the first hole, and what
/// the cycle leaves behind is the direction in force for the blocks after it.
#pragma once

#include "isogloss/cnc/canned_cycle.hpp"

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

/// Of a cycle that stops the spindle and starts it again.
class RestartedSpindle : public CycleSpindle {
 public:
  /// How the cycle starts it; `code` is the cycle's.
  Spindle begin(Block& b, const CompoundMotion& motion, const Where& where, Symbol code) const {
    const bool ccw = turns_ccw(b);
    if (ccw && restart_ == Restart::clockwise) b.report(diag("ISO-0336"), where, b.text(code));
    const auto start = ccw && restart_ == Restart::as_before ? Spindle::ccw : Spindle::cw;
    CycleSpindle::begin(b, motion, start);
    return start;
  }

 private:
  enum class Restart { clockwise, as_before };
  Choice<Restart> restart_{"restart", "clockwise|as-before", "clockwise",
                           "How the cycle restarts the spindle: clockwise, or in its previous direction."};
};

/// Fewer holes where the steps of all would be too many; says so. Counts one step for an M code of the block.
inline void limit_steps(Block& b, CycleRun& run, std::int64_t steps_per_hole) {
  const std::int64_t room = (most_steps - 1) / steps_per_hole;
  if (run.count <= room) return;
  b.report(diag("ISO-0352"), Where::block(), b.text(run.code), static_cast<double>(run.count),
           static_cast<double>(steps_per_hole), static_cast<double>(room));
  run.count = static_cast<int>(room);
}

}  // namespace ig::cnc
