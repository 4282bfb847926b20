/// Between M29 and the tapping cycle the control allows no move, no S and no spindle code. This syntax runs after all
/// that move the axes, so that it sees each of them: words of an axis, a return to the reference point, another cycle.

#include <isogloss/sdk.hpp>

namespace iso {
namespace {

struct RigidTappingCheck {
  static constexpr auto spec =
      ig::syntax("RigidTappingCheckSyntax", "Reports what stands between M29 and the tapping cycle.")
          .after("RigidTappingModeSyntax", "SpindleOrientationSyntax", "LinearMotionSyntax", "CircularMotionSyntax",
                 "ReferenceReturnSyntax", "FurtherAxesSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0350",
                     "{0} is programmed between M29 and the tapping cycle: program the cycle directly after M29"),
      ig::diagnostic(IG_WARNING, "ISO-0398",
                     "M29 is not read as rigid tapping: {0} follows it instead of a tapping cycle"),
  };

  ig::Signal awaits_cycle_{"RigidTapping.~AwaitsCycle", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::Signal is_unsure_{"RigidTapping.~IsUnsure", ig::read, ig::Life::modal};
  ig::Signal said_{"RigidTapping.~Said", ig::read | ig::write, ig::Life::modal};
  ig::Out<ig::Symbol> term_{"RigidTapping.Term"};
  ig::In<ig::Symbol> move_{"MotionEvent.Form"}, steps_{"CompoundMotion.Term"};
  ig::Signal further_axes_moved_{"FurtherAxes.~Moved", ig::read};
  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"}, surface_speed_{"SpindleSpeed.SurfaceSpeed"};
  ig::In<ig::Symbol> direction_{"SpindleSpeed.Direction"};

  ig::Status build(ig::Block& b) {
    // The block of M29 itself may hold S.
    if (!b.is_raised(awaits_cycle_) || b.is_fresh(term_)) return ig::Status::unchanged;
    const std::string_view what = disturbance(b);
    if (what.empty() && b.has(term_)) return ig::Status::unchanged;
    b.erase(awaits_cycle_);
    if (!what.empty()) report(b, what);
    return ig::Status::changed;
  }

 private:
  std::string_view disturbance(const ig::Block& b) const {
    if (b.is_fresh(move_) || b.is_fresh(steps_) || b.is_raised(further_axes_moved_)) return "a move";
    if (b.is_fresh(speed_) || b.is_fresh(surface_speed_)) return "S";
    return b.is_fresh(direction_) ? "a spindle code" : "";
  }

  void report(ig::Block& b, std::string_view what) const {
    if (!b.is_raised(is_unsure_)) {
      b.report(ig::diag("ISO-0350"), ig::Where::block(), what);
      return;
    }
    if (!b.is_raised(said_)) b.report(ig::diag("ISO-0398"), ig::Where::block(), what);
    b.raise(said_);
    if (b.has(term_)) b.erase(term_);
  }
};

const ig::Register<RigidTappingCheck> rigid_tapping_check_syntax;

}  // namespace
}  // namespace iso
