/// The way into a hole that is drilled or bored in one stroke.
#pragma once

#include <isogloss/cnc/canned_cycle.hpp>

namespace iso {

using namespace ig::cnc;

struct Stroke {
  double feed;   ///< mm/s
  double dwell;  ///< s at the bottom; 0: none
};

/// Rapid to the hole, rapid to R, feed to the bottom, dwell.
inline void feed_to_bottom(ig::CompoundSteps& steps, const CycleRun& run, const CycleHole& hole, const Stroke& stroke) {
  steps.rapid_to(hole.at(hole.approach_level));
  steps.rapid_to(hole.at(run.r_level));
  steps.feed_to(hole.at(run.bottom), stroke.feed);
  if (stroke.dwell > 0) steps.dwell(stroke.dwell);
}

}  // namespace iso
