/// The spindle around a cycle that turns it itself: an M code of the same block acts before the first hole, and what
/// the cycle leaves behind is the direction in force for the blocks after it.
#pragma once

#include "canned_cycle_util.hpp"

namespace iso {

class CycleSpindle {
 public:
  /// M03, M04, M05 (M29) of this block, as a step, unless the order of events of a block says the same: a start comes
  /// before the steps, but a stop after them. Then the direction in force is `last`.
  void begin(ig::Block& b, const ig::CompoundMotion& motion, ig::Spindle last) const {
    const auto now = b.get(direction_);
    if (!now) return;
    const bool is_programmed_here = b.is_fresh(direction_);
    const bool stays = *now == name(last);
    if (is_programmed_here && (!stays || *now == stop_))
      motion.spindle(b, *now == cw_ ? ig::Spindle::cw : *now == ccw_ ? ig::Spindle::ccw : ig::Spindle::stop);
    if (stays) return;
    if (is_programmed_here) b.erase(direction_);  // said by the step already
    b.amend(direction_, name(last));
  }

  /// How the spindle turns when the cycle begins; empty when nothing was ever said.
  std::optional<ig::Symbol> direction(const ig::Block& b) const { return b.get(direction_); }
  ig::Symbol name(ig::Spindle direction) const {
    return direction == ig::Spindle::cw ? cw_ : direction == ig::Spindle::ccw ? ccw_ : stop_;
  }

 protected:
  bool turns_ccw(const ig::Block& b) const { return b.is(direction_, ccw_); }

 private:
  ig::Out<ig::Symbol> direction_{"SpindleSpeed.Direction"};
  ig::Name cw_{"CW"}, ccw_{"CCW"}, stop_{"STOP"};
};

/// Of a cycle that stops the spindle and starts it again.
class RestartedSpindle : public CycleSpindle {
 public:
  /// How the cycle starts it; `code` is the cycle's.
  ig::Spindle begin(ig::Block& b, const ig::CompoundMotion& motion, const ig::Where& where, ig::Symbol code) const {
    const bool ccw = turns_ccw(b);
    if (ccw && restart_ == Restart::clockwise) b.report(ig::diag("ISO-0336"), where, b.text(code));
    const auto start = ccw && restart_ == Restart::as_before ? ig::Spindle::ccw : ig::Spindle::cw;
    CycleSpindle::begin(b, motion, start);
    return start;
  }

 private:
  enum class Restart { clockwise, as_before };
  ig::Choice<Restart> restart_{"restart", "clockwise|as-before", "clockwise",
                               "How the cycle starts the spindle again: clockwise, or as it turned before."};
};

/// Fewer holes where the steps of all would be too many; says so. Counts one step for an M code of the block.
inline void limit_steps(ig::Block& b, CycleRun& run, std::int64_t steps_per_hole) {
  const std::int64_t room = (most_steps - 1) / steps_per_hole;
  if (run.count <= room) return;
  b.report(ig::diag("ISO-0352"), ig::Where::block(), b.text(run.code), static_cast<double>(run.count),
           static_cast<double>(steps_per_hole), static_cast<double>(room));
  run.count = static_cast<int>(room);
}

}  // namespace iso
