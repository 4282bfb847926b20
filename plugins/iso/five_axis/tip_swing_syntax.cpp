/// G53.6 with R or H, and what PLANE … MOVE DIST becomes: a point at a distance from the tip rests while the rotary
/// axes turn, so the tip swings about it on an arc in space. Moves are straight lines of the tip, so this move becomes
/// as many lines as stay within the tolerance of the arc.
#include <numbers>

#include <isogloss/cnc/event_to_steps.hpp>
#include <isogloss/cnc/rotary_words.hpp>
#include <isogloss/cnc/tool_kinematics.hpp>
#include <isogloss/cnc/units.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct TipSwing {
  static constexpr auto spec =
      ig::syntax("TipSwingSyntax", "G53.6 R: swings the tool tip about a resting point, in steps.")
          .after("G53p1RotaryPositionSyntax", "PivotTransformationSyntax", "McXyzSyntax", "McAbcSyntax",
                 "McAbcCyclicPathSyntax", "LinearMotionSyntax")
          .before("TravelCheckSyntax");

  ig::Field<double> lever_{"PivotTransform.Lever_mm",
                           ig::read | ig::wake,
                           {ig::Life::block, "mm", "How far beyond the tip the point lies that rests under G53.6."}};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::In<double> length_{"ToolHeightCompensation.Offset_mm"};
  ig::Xyz begin_{"MachineCoordinate", ig::previous};
  ig::Xyz end_{"MachineCoordinate", ig::read};
  RotaryPosition rotary_before_{ig::previous};
  RotaryPosition rotary_{ig::read};
  ig::In<ig::Symbol> motion_code_{"MotionState.Term"};
  ig::Out<ig::Symbol> compound_{"CompoundMotion.Term"};
  ig::NumberOption tolerance_{
      "tolerance", "0.01", {0.0001, 100}, "mm", "How far a straight step of the tip may deviate from the arc."};
  EventToSteps event_;
  ToolSteps steps_;
  ToolKinematics machine_;
  ig::Name led_{"ClLinear"};

  ig::Status build(ig::Block& b) const {
    const auto lever = b.get(lever_);
    const ig::PartialVec3 begin = b.get(begin_), end = b.get(end_);
    if (!lever || !machine_ || !b.is(form_, led_) || !begin.complete() || !end.complete()) return ig::Status::unchanged;
    const Angles from = rotary_before_.get(b).or_else({}), to = rotary_.get(b).or_else(from);
    const double count = steps_within_tolerance(*lever, from, to);
    const ToolTip tool{machine_, b.get_or(length_, 0.0)};
    const auto first = tool.in_workpiece(begin.value, from);
    const auto axis = machine_.tool_axis(from);
    if (count < 2 || !first) return ig::Status::unchanged;
    const ig::Vec3 rests = *first - *lever * *axis;
    const ToolSteps::Manner manner = event_.take(b);
    for (double step = 1; step < count; ++step) {
      PartialAngles turned{machine_.mask(), from};
      for (std::size_t i = 0; i < 3; ++i) turned.value[i] += step / count * (to[i] - from[i]);
      append(b, tool, rests, *lever, turned, to, manner);
    }
    if (const auto program = b.to_program(end.value))
      steps_.led(b, rounded(*program), end.value, {machine_.mask(), to}, manner);
    if (const auto code = b.get(motion_code_)) b.set(compound_, *code);
    return ig::Status::changed;
  }

 private:
  static constexpr double most_steps = 10000;

  /// A chord over the angle q is at most lever q² / 8 from its arc; q is no more than the sum of the axes' angles.
  double steps_within_tolerance(double lever, const Angles& from, const Angles& to) const {
    double turned = 0;
    for (std::size_t i = 0; i < 3; ++i) turned += std::fabs(to[i] - from[i]) * radians_per_degree;
    return std::fmin(std::ceil(turned * std::sqrt(std::fabs(lever) / (8 * tolerance_))), most_steps);
  }

  /// The frame of the block is that of its end: a program point is where the tip has it in the workpiece then.
  void append(ig::Block& b, const ToolTip& tool, const ig::Vec3& rests, double lever, const PartialAngles& turned,
              const Angles& end, const ToolSteps::Manner& manner) const {
    const auto axis = machine_.tool_axis(turned.value);
    if (!axis) return;
    const ig::Vec3 tip = rests + lever * *axis;
    const auto at = tool.machine_point(tip, turned.value), at_end = tool.machine_point(tip, end);
    const auto program = at_end ? b.to_program(*at_end) : std::nullopt;
    if (at && program) steps_.led(b, rounded(*program), rounded(*at), turned, manner);
  }
};

const ig::Register<TipSwing> tip_swing_syntax;

}  // namespace
}  // namespace iso
