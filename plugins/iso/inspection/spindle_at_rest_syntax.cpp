/// Reports a move whose feed counts turns of a spindle that is at rest: the axes would never arrive.
#include <isogloss/sdk.hpp>

namespace iso {
namespace {

struct SpindleAtRest {
  static constexpr auto spec =
      ig::syntax("SpindleAtRestSyntax", "Reports a feed per revolution while the spindle is at rest.")
          .after("FeedrateSyntax", "SpindleSpeedSyntax", "SpindleOrientationSyntax", "TappingCycleSyntax",
                 "LinearMotionSyntax", "CircularMotionSyntax", "ThreadCuttingSyntax", "MachineCodeFieldSyntax",
                 "SiemensThreadSyntax", "SiemensTappingCycleSyntax", "SiemensTurnSyntax", "KlartextTappingCycleSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0604",
                     "the move follows the turns of the spindle, which is at rest, so the axes would stand still: "
                     "program M03 or M04 first"),
  };

  ig::InWhile<ig::Symbol> while_per_revolution_{"Feedrate.Term", "G95"};
  /// After a thread; G33 itself would be looked for whenever the motion code changes.
  ig::InWhile<double> while_threaded_{"ThreadCutting.Lead"};
  ig::Field<ig::Symbol> thread_{
      "ThreadCutting.Term", ig::read | ig::wake | ig::wake_while, {ig::Life::modal, "", ""}};  // Siemens
  ig::In<ig::Symbol> feed_mode_{"Feedrate.Term", ig::wake};
  ig::In<double> lead_{"ThreadCutting.Lead", ig::wake};
  ig::In<ig::Symbol> motion_code_{"MotionState.Term"};
  ig::In<ig::Symbol> direction_{"SpindleSpeed.Direction", ig::wake};
  ig::Previous<ig::Symbol> direction_before_{"SpindleSpeed.Direction"};
  ig::In<double> feed_{"MotionEvent.Feedrate_mmds"};
  ig::Field<double> feed_of_step_{"CompoundMotion.Items[].MotionEvent.Feedrate_mmds", ig::read};
  ig::Field<ig::Symbol> spindle_of_step_{"CompoundMotion.Items[].SpindleControl.Direction", ig::read};
  /// Of the present stretch without a turn.
  ig::Signal said_{"SpindleAtRest.~Said", ig::read | ig::write, ig::Life::modal};
  ig::Name g95_{"G95"}, g33_{"G33"}, stop_{"STOP"};

  ig::Status build(ig::Block& b) {
    // A stop of this block comes after its move.
    const bool is_at_rest = b.is(direction_, stop_) && b.is(direction_before_, stop_);
    if (!is_at_rest) {
      if (!b.is_raised(said_)) return ig::Status::unchanged;
      b.erase(said_);
      return ig::Status::changed;
    }
    const bool threads = b.is(motion_code_, g33_) || b.is(thread_, g33_);
    if (b.is_raised(said_) || !(threads || b.is(feed_mode_, g95_)) || !(b.has(feed_) || has_step_at_rest(b)))
      return ig::Status::unchanged;
    b.report(ig::diag("ISO-0604"), ig::Where::block());
    b.raise(said_);
    return ig::Status::changed;
  }

 private:
  /// A cycle that turns the spindle itself does so before its first feed.
  bool has_step_at_rest(const ig::Block& b) const {
    const std::uint32_t steps = b.count(feed_of_step_.id());
    const std::array<ig_field, 2> fields{feed_of_step_.id(), spindle_of_step_.id()};
    for (std::uint32_t step = 0; step < steps; ++step) {
      std::array<ig_value, 2> values;
      const std::uint32_t known = b.record(step, fields.data(), 2, values.data());
      if ((known & 2u) != 0) return false;
      if ((known & 1u) != 0) return true;
    }
    return false;
  }
};

const ig::Register<SpindleAtRest> spindle_at_rest_syntax;

}  // namespace
}  // namespace iso
