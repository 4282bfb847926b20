/// What the drilling cycles share: the parameters of their call, their levels along the drilling axis, and the way to
/// them.
#pragma once

#include <cmath>
#include <span>

#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>

#include "cycles/cycle_feed.hpp"
#include "cycles/hole_pattern.hpp"

namespace siemens {

using namespace ig::cnc;

/// How a dwell is programmed: in seconds, in spindle turns, or the one or the other by its sign.
enum class DwellUnit { by_sign, seconds, turns };

/// A call while its cycle is executed. Levels are positions of the drilling axis, in mm.
struct DrillingRun {
  const CycleFields* cycle = nullptr;
  CycleFields::Values values;
  PlaneAxes plane;
  ig::Vec3 hole;                                     ///< along the drilling axis: where the tool comes from
  std::optional<std::span<const ig::Vec3>> pattern;  ///< the holes of a pattern (HOLES1, …)
  double retract = 0, reference = 0, start = 0, depth = 0;
  double out = 1;  ///< 1 where the axis leaves the hole in its positive direction, else -1
  double feed = 0;
  double dwell = 0;  ///< DTB in seconds

  std::optional<double> operator[](std::string_view parameter) const {
    const std::size_t i = cycle->index_of(parameter);
    return i < values.size() ? values[i] : std::nullopt;
  }
  /// A digit of a mode parameter such as AMODE, counted from the right.
  double mode(std::string_view parameter, int digit) const {
    return std::fmod(std::floor((*this)[parameter].value_or(0) / std::pow(10, digit)), 10);
  }
  DwellUnit dwell_unit(int digit) const {
    const double unit = mode("AMODE", digit);
    return unit == 1 ? DwellUnit::seconds : unit == 2 ? DwellUnit::turns : DwellUnit::by_sign;
  }
  ig::Vec3 at(double level) const { return plane.at_level(hole, level); }
};

/// A member of each cycle syntax.
class DrillingCall {
 public:
  DrillingCall(std::initializer_list<std::string_view> names);

  /// The call of this block, and the block's own move to the hole before it. Nothing where there is no call, or where
  /// the control refuses it, which is reported: X Y Z of the block then move as without the call.
  std::optional<DrillingRun> take(ig::Block& b);

  /// Makes the steps at each hole, after a rapid in the plane to it where a pattern names the holes.
  template <class Steps>
  void drill(ig::Block& b, DrillingRun& run, const Steps& steps) const {
    if (!run.pattern) {
      steps(run);
    } else {
      double level = last_(b)[run.plane.tool];
      for (const ig::Vec3& hole : *run.pattern) {
        run.hole = hole;
        motion.rapid_to(b, run.at(level));
        steps(run);
        level = run.retract;
      }
      if (run.pattern->empty()) {
        stay(b, run);
        return;
      }
    }
    b.set(program_, run.at(run.retract));
  }

  /// The control stops before the hole: no step is made.
  void stay(ig::Block& b, const DrillingRun& run) const;

  static ig::Where where(const DrillingRun& run, std::string_view parameter = {});

  /// The dwell in seconds. The number is spindle turns where it is negative, or where the mode (AMODE) says so.
  double seconds(ig::Block& b, const DrillingRun& run, std::optional<double> number,
                 DwellUnit unit = DwellUnit::by_sign) const;

  ig::CompoundMotion motion;
  CycleFeed feed;

 private:
  /// The plane of the call (DMODE), else the one in force.
  PlaneAxes plane_of(const ig::Block& b, const DrillingRun& run) const;

  /// Computes the rest of the run from the values of the call. False, with a diagnostic, where the control refuses it.
  bool resolve(ig::Block& b, DrillingRun& run) const;
  bool levels(ig::Block& b, DrillingRun& run) const;
  /// The block's own move to the hole, by the motion code in force.
  void approach(ig::Block& b, DrillingRun& run) const;

  std::vector<CycleFields> cycles_;
  HolePattern pattern_{ig::take};
  ig::Xyz words_{"Parsing", ig::take};
  // Rotary axes turn with the first step, on the way to the hole.
  std::array<ig::Word, 3> angles_{ig::Word{"Parsing.A", ig::read, "deg"}, ig::Word{"Parsing.B", ig::read, "deg"},
                                  ig::Word{"Parsing.C", ig::read, "deg"}};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Codes codes_{{"G00", "G01", "G02", "G03"}, ig::read};
  ig::In<ig::Symbol> state_{"MotionState.Term"};
  PlaneInForce plane_;
  LastProgramXyz last_;
};

}  // namespace siemens
