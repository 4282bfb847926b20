/// The feed of a straight block in which rotary axes turn. One degree counts like one unit of length of the program, so
/// F of a block that only turns is in degrees per minute, whatever the unit. Reports what BlockMotion reports.
#pragma once

#include <cmath>

#include <isogloss/cnc/motion_event.hpp>
#include <isogloss/cnc/rotary_words.hpp>
#include <isogloss/cnc/units.hpp>

namespace iso {

using namespace ig::cnc;

enum class FeedCounts { linear_axes, all_axes };

class TurningFeed {
 public:
  bool turns(const ig::Block& b) const { return rotary_.fresh(b) != 0; }

  /// The move of a block, `linear` mm long in program coordinates, that turns axes.
  void feed(ig::Block& b, const BlockMotion& motion, double linear, FeedCounts counts,
            const MotionGroup::Entry& in_force = {}) const {
    const bool only_turns = linear < same_way_mm;
    if (!only_turns && (counts == FeedCounts::linear_axes || b.is_raised(tip_is_led_))) {
      motion.feed(
          b, [&] { return linear; }, in_force);
      return;
    }
    const double turned = turn(b), unit = b.is(unit_, inch_) ? mm_per_inch : 1;
    motion.feed(
        b, [&] { return only_turns ? turned : linear; }, in_force);
    const auto feed = b.get(feedrate_);
    if (!feed || b.is(feed_mode_, g93_)) return;
    if (only_turns) {
      if (unit != 1) b.set(feedrate_, *feed / unit);  // F is in mm by now
    } else {
      b.set(feedrate_, *feed * linear / std::hypot(linear, unit * turned));
    }
  }

 private:
  double turn(const ig::Block& b) const {
    const PartialAngles from = rotary_before_.get(b), to = rotary_.get(b);
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!to.has(axis)) continue;
      const double way = to.value[axis] - (from.has(axis) ? from.value[axis] : 0);  // an axis without a place is at 0
      sum += way * way;
    }
    return std::sqrt(sum);
  }

  static constexpr double same_way_mm = 1e-7;  // a shorter way is rounding of the frame

  RotaryPosition rotary_{ig::read};
  RotaryPosition rotary_before_{ig::previous};
  ig::Signal tip_is_led_{"PivotTransform.~Turns", ig::read};
  ig::In<ig::Symbol> feed_mode_{"Feedrate.Term"};
  ig::Out<double> feedrate_{"MotionEvent.Feedrate_mmds"};
  ig::In<ig::Symbol> unit_{"Unit.System"};
  ig::Name g93_{"G93"}, inch_{"Inch"};
};

}  // namespace iso
