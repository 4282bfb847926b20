/// G33: a straight move coupled to the spindle; F is the lead. Modal, of group 01. Fanuc manual, "Thread cutting".
#include <isogloss/cnc/motion_event.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct ThreadCutting {
  static constexpr auto spec =
      ig::syntax("ThreadCuttingSyntax", "G33 thread cutting with a constant lead.")
          .after("FeedrateSyntax", "SpindleSpeedSyntax", "McXyzSyntax", "CircularMotionSyntax", "LinearMotionSyntax")
          .first_writer("Motion");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0391",
                     "G33 F{0}: the lead must be greater than zero, so the previous lead stays in force"),
  };

  ig::Call g33_{{"G33"}, "F[mm] Q[deg]"};
  ig::InWhile<ig::Symbol> while_threading_{"MotionState.Term", "G33"};
  ig::Xyz machine_{"MachineCoordinate", ig::read};
  ig::In<double> feed_{"Feedrate.FeedrateValue"};
  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::Out<double> lead_{"ThreadCutting.Lead"};
  ig::Out<double> start_{"ThreadCutting.StartAngle_deg"};
  MotionGroup group_;
  BlockMotion motion_;

  ig::Status build(ig::Block& b) {
    const auto words = b.take(g33_);
    std::uint32_t found = 0;
    const auto named = group_.find(b, found);
    if ((named ? *named : group_.in_force(b)) != MotionGroup::g33) return give_up(b, words);
    bool has_changed = words.has_value();
    if (words && (*words)['F']) take_lead(b, *(*words)['F'], g33_.word(0, 'F'));
    if (!words && b.is_fresh(feed_)) has_changed |= take_lead(b, b.get_or(feed_, 0.0), feed_.id());
    if (words) {
      b.set(start_, (*words)['Q'].value_or(0));
      group_.take(b, MotionGroup::g33, found);
    }
    if (!b.is_fresh(machine_) || motion_.is_moving(b)) return has_changed ? ig::Status::changed : ig::Status::unchanged;
    if (!words) group_.put_in_force(b, MotionGroup::g33);
    motion_.straight(b, speed(b));
    return ig::Status::changed;
  }

 private:
  /// Another motion code follows G33 in its block; ParameterizedFlagSyntax has left the words to it.
  ig::Status give_up(ig::Block& b, const std::optional<ig::Words>& words) const {
    if (!words) return ig::Status::unchanged;
    b.erase(lead_);
    return ig::Status::changed;
  }

  /// Whether the lead is in force.
  bool take_lead(ig::Block& b, double lead, ig_field word) const {
    if (lead > 0)
      b.set(lead_, lead);
    else
      b.report(ig::diag("ISO-0391"), ig::Where::word(word), lead);
    return lead > 0;
  }

  /// mm/s; 0 where lead or spindle speed is unknown.
  double speed(ig::Block& b) const {
    const double lead = b.get_or(lead_, 0.0), turns = b.get_or(speed_, 0.0) / 60;
    if (lead <= 0)
      b.report(ig::diag("ISO-0302"), ig::Where::block());
    else if (turns <= 0)
      b.report(ig::diag("ISO-0303"), ig::Where::block());
    return lead * turns;
  }
};

const ig::Register<ThreadCutting> thread_cutting_syntax;

}  // namespace
}  // namespace iso
