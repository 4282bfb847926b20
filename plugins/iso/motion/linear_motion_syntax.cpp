/// G00 and G01: the block goes to its machine point on a straight line, by rapid or by feed. The code stays in force
/// until another code of group 01.
#include <isogloss/cnc/motion_event.hpp>
#include <isogloss/cnc/rotary_words.hpp>
#include <isogloss/cnc/units.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

enum class FeedCounts { linear_axes, all_axes };

struct LinearMotion {
  static constexpr auto spec = ig::syntax("LinearMotionSyntax", "G00/G01 straight motion.")
                                   .after("FeedrateSyntax", "McXyzSyntax", "CircularMotionSyntax")
                                   .before("ReferenceReturnSyntax")
                                   .first_writer("Motion");

  ig::Codes straight_{{"G00", "G01"}, ig::wake};
  ig::Xyz machine_{"MachineCoordinate", ig::read | ig::wake};
  ig::Xyz program_{"ProgramXyz", ig::read};
  RotaryPosition rotary_{ig::read};
  RotaryPosition rotary_before_{ig::previous};
  ig::Signal tip_is_led_{"PivotTransform.~Turns", ig::read};
  ig::In<ig::Symbol> feed_mode_{"Feedrate.Term"};
  ig::Out<double> feedrate_{"MotionEvent.Feedrate_mmds"};
  ig::In<ig::Symbol> unit_{"Unit.System"};
  ig::Name g93_{"G93"}, inch_{"Inch"};
  ig::Choice<FeedCounts> feed_counts_{"feed-counts", "linear-axes|all-axes", "linear-axes",
                                      "Which motion F sets the speed of, in a block that moves X Y Z and rotary axes."};
  MotionGroup group_;
  BlockMotion motion_;
  LastProgramXyz last_;

  ig::Status build(ig::Block& b) {
    if (group_.is_answered(b)) return ig::Status::unchanged;
    std::uint32_t found = 0;
    const auto named = group_.find(b, found);
    const std::size_t code = named ? *named : group_.in_force(b);
    if (code > MotionGroup::g01) return ig::Status::unchanged;
    const bool moves = b.is_fresh(machine_) && !motion_.is_moving(b);
    if (!moves) {
      if (!named) return ig::Status::unchanged;
      group_.take(b, code, found);
      return ig::Status::changed;
    }
    if (named) group_.take_codes(b, code, found);
    const MotionGroup::Entry in_force = group_.entry(code);
    if (code == MotionGroup::g00)
      motion_.rapid(b, in_force);
    else if (rotary_.fresh(b) != 0)
      feed_and_turn(b, in_force);
    else
      motion_.feed(
          b, [&] { return way(b); }, in_force);
    return ig::Status::changed;
  }

 private:
  double way(ig::Block& b) const { return length(b.get(program_).or_else({}) - last_(b)); }

  /// One degree counts like one unit of length of the program; F is in mm by now.
  void feed_and_turn(ig::Block& b, const MotionGroup::Entry& in_force) const {
    const double linear = way(b);
    const bool only_turns = linear < same_way_mm;
    if (!only_turns && (feed_counts_ == FeedCounts::linear_axes || b.is_raised(tip_is_led_))) {
      motion_.feed(
          b, [&] { return linear; }, in_force);
      return;
    }
    const double turned = turn(b), unit = b.is(unit_, inch_) ? mm_per_inch : 1;
    motion_.feed(
        b, [&] { return only_turns ? turned : linear; }, in_force);
    const auto feed = b.get(feedrate_);
    if (!feed || b.is(feed_mode_, g93_)) return;
    if (only_turns) {
      if (unit != 1) b.set(feedrate_, *feed / unit);
    } else {
      b.set(feedrate_, *feed * linear / std::hypot(linear, unit * turned));
    }
  }
  double turn(const ig::Block& b) const {
    const PartialAngles from = rotary_before_.get(b), to = rotary_.get(b);
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (from.has(axis) && to.has(axis))
        sum += (to.value[axis] - from.value[axis]) * (to.value[axis] - from.value[axis]);
    return std::sqrt(sum);
  }

  static constexpr double same_way_mm = 1e-7;  // a shorter way is rounding of the frame
};

const ig::Register<LinearMotion> linear_motion_syntax;

}  // namespace
}  // namespace iso
