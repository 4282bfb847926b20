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
inline void feed_to_bottom(ig::Block& b, const ig::CompoundMotion& motion, const CycleRun& run, const CycleHole& hole,
                           const Stroke& stroke) {
  motion.rapid_to(b, hole.at(hole.approach_level));
  motion.rapid_to(b, hole.at(run.r_level));
  motion.feed_to(b, hole.at(run.bottom), stroke.feed);
  if (stroke.dwell > 0) motion.dwell(b, stroke.dwell);
}

}  // namespace iso
