/// The spindle of a canned cycle that stops it in the hole and starts it again, and the limit on the number of holes
/// whose steps fit into one block.
#pragma once

#include "isogloss/cnc/canned_cycle.hpp"
#include "isogloss/cnc/cycle_spindle.hpp"

namespace ig::cnc {

inline const Diagnostics restarted_spindle_diagnostics{
    diagnostic(IG_WARNING, "ISO-0336",
               "the spindle turned counter-clockwise, but {0} restarts it clockwise: program M04 after the cycle",
               "The cycle stops the spindle at the bottom and restarts it with M03, whatever its direction was "
               "before. A left-hand tool cuts backwards from here on, until M04.",
               "M04 S500 G86 X10. Y10. Z-20. R2. F100"),
    diagnostic(IG_ERROR, "ISO-0352", "{0}: {1} holes of {2} steps are too many for one block: only {3} holes are made",
               "A block makes at most 100000 steps. Write several blocks, with a smaller K each.",
               "G91 G87 X1. Z-1. R-1. Q0.1 F90 K10000"),
};

/// The spindle of a cycle that stops it and starts it again. A member of the cycle's syntax.
class RestartedSpindle : public CycleSpindle {
 public:
  /// Returns the direction in which the cycle `code` restarts the spindle. Reports ISO-0336 at `where` when an M04
  /// spindle restarts clockwise, because the option `restart` says so.
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

/// Reduces the number of holes so that all steps fit into the host's list, and reports ISO-0352 when it does. One step
/// is kept for an M code of the block.
inline void limit_steps(Block& b, CycleRun& run, std::int64_t steps_per_hole) {
  const std::int64_t room = (most_steps - 1) / steps_per_hole;
  if (run.count <= room) return;
  b.report(diag("ISO-0352"), Where::block(), b.text(run.code), static_cast<double>(run.count),
           static_cast<double>(steps_per_hole), static_cast<double>(room));
  run.count = static_cast<int>(room);
}

}  // namespace ig::cnc
