/// M29: the tapping cycles that follow are rigid, axis and spindle are coupled. M29 stops the spindle, and the cycle
/// starts it. The mode ends with G80 or a motion code, like the cycles. Many machines use M29 for another function: an
/// M29 without S that is not followed by a tapping cycle is read as that.

#include <isogloss/sdk.hpp>

namespace iso {
namespace {

struct RigidTappingMode {
  static constexpr auto spec = ig::syntax("RigidTappingModeSyntax", "M29 rigid tapping mode.")
                                   .after("SpindleSpeedSyntax")
                                   .before("CannedCycleResolveSyntax", "LinearMotionSyntax");
  ig::Codes m29_{"M29"};
  ig::Field<ig::Symbol> term_{"RigidTapping.Term",
                              ig::read | ig::write | ig::wake_while,
                              {ig::Life::modal, "", "The code that made tapping rigid; absent where it is not."}};
  /// RigidTappingCheckSyntax watches the blocks up to the cycle.
  ig::Signal awaits_cycle_{"RigidTapping.~AwaitsCycle", ig::read | ig::write, ig::Life::modal};
  /// M29 has no S: nothing is stopped before the cycle comes.
  ig::Signal is_unsure_{"RigidTapping.~IsUnsure", ig::read | ig::write, ig::Life::modal};
  ig::Out<ig::Symbol> direction_{"SpindleSpeed.Direction"};
  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::Codes end_{{"G80", "G00", "G01", "G02", "G03", "G33"}, ig::read};
  ig::Call tapping_{{"G74", "G84"}, "", ig::read};
  ig::In<ig::Symbol> cycle_{"CannedCycle.Term"};
  ig::Name stop_{"STOP"}, g74_{"G74"}, g84_{"G84"};

  ig::Status build(ig::Block& b) {
    const bool taps = b.find(tapping_) || b.is(cycle_, g84_) || b.is(cycle_, g74_);
    if (b.take(m29_)) {
      b.set(term_, m29_.name(0));
      b.erase(is_unsure_);
      if (taps || b.is_fresh(speed_))
        b.set(direction_, stop_);
      else
        b.raise(is_unsure_);
      if (!taps) b.raise(awaits_cycle_);
      return ig::Status::changed;
    }
    if (!b.has(term_)) return ig::Status::unchanged;
    const bool starts = taps && b.is_raised(awaits_cycle_), ends = b.find(end_) && !b.find(tapping_);
    if (starts && b.is_raised(is_unsure_)) b.set(direction_, stop_);
    if (starts) b.erase(awaits_cycle_);
    if (ends) b.erase(term_);
    return starts || ends ? ig::Status::changed : ig::Status::unchanged;
  }
};

const ig::Register<RigidTappingMode> rigid_tapping_mode_syntax;

}  // namespace
}  // namespace iso
