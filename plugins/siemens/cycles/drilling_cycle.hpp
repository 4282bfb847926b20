/// What the drilling cycles share: the parameters of their call, their levels along the drilling axis, and the way to
/// them.
#pragma once

#include <cmath>

#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>

#include "cycles/hole_pattern.hpp"

namespace siemens {

using namespace ig::cnc;

/// The feed in force, as FeedrateSyntax writes it.
class FeedInForce {
 public:
  /// The feed `own`, or the F in force, in mm/s; 0 where it is not known.
  double mmds(const ig::Block& b, std::optional<double> own = std::nullopt) const {
    const double f = own.value_or(b.get_or(value_, 0.0));
    if (!(f > 0)) return 0;
    if (b.is(term_, g95_)) return f * b.get_or(rpm_, 0.0) / 60;
    return b.is(term_, g93_) ? 0 : f / 60;
  }
  double rpm(const ig::Block& b) const { return b.get_or(rpm_, 0.0); }

 private:
  ig::In<double> value_{"Feedrate.FeedrateValue"};
  ig::In<ig::Symbol> term_{"Feedrate.Term"};
  ig::In<double> rpm_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::Name g93_{"G93"}, g95_{"G95"};
};

/// How a dwell is programmed: in seconds, in spindle turns, or the one or the other by its sign.
enum class DwellUnit { by_sign, seconds, turns };

/// A call while its cycle is executed. Levels are positions of the drilling axis, in mm.
struct DrillingRun {
  const CycleFields* cycle = nullptr;
  std::array<std::optional<double>, CycleFields::most> values;
  PlaneAxes plane;
  ig::Vec3 hole;                                 ///< along the drilling axis: where the tool comes from
  std::optional<std::vector<ig::Vec3>> pattern;  ///< the holes of a pattern (HOLES1, …)
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
  DrillingCall(std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) cycles_.emplace_back(drilling_signature(name), ig::take | ig::wake);
  }

  /// The call of this block, and the block's own move to the hole before it. Nothing where there is no call, or where
  /// the control refuses it, which is reported: X Y Z of the block then move as without the call.
  std::optional<DrillingRun> take(ig::Block& b) const {
    for (const CycleFields& cycle : cycles_) {
      std::uint32_t found = 0;
      if (b.take_code(cycle.code().codes(), 1, &found) < 0) continue;
      DrillingRun run;
      run.cycle = &cycle;
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        ig_value v;
        if (b.take(cycle.field(i).id(), v)) run.values[i] = v.number;
      }
      if (!resolve(b, run)) {
        pattern_.take(b, run.plane, last_(b));
        b.alarm();
        return std::nullopt;
      }
      run.pattern = pattern_.take(b, run.plane, last_(b));
      motion.begin(b, cycle.code().name(0));
      if (!run.pattern) approach(b, run);
      return run;
    }
    return std::nullopt;
  }

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
  void stay(ig::Block& b, const DrillingRun& run) const {
    b.set(program_, run.hole);
    b.alarm();
  }

  static ig::Where where(const DrillingRun& run, std::string_view parameter = {}) {
    const std::size_t i = parameter.empty() ? run.cycle->size() : run.cycle->index_of(parameter);
    return ig::Where::word(i < run.cycle->size() ? run.cycle->field(i).id() : run.cycle->code().code(0));
  }

  /// The dwell in seconds. The number is spindle turns where it is negative, or where the mode (AMODE) says so.
  double seconds(ig::Block& b, const DrillingRun& run, std::optional<double> number,
                 DwellUnit unit = DwellUnit::by_sign) const {
    if (!number || *number == 0) return 0;
    if (unit == DwellUnit::seconds || (unit == DwellUnit::by_sign && *number > 0)) return std::fabs(*number);
    const double rpm = feed.rpm(b);
    if (rpm > 0) return std::fabs(*number) * 60 / rpm;
    b.report(ig::diag("SIE-0187"), where(run), run.cycle->name(), *number);
    return 0;
  }

  ig::CompoundMotion motion;
  FeedInForce feed;

 private:
  /// The plane of the call (DMODE), else the one in force.
  PlaneAxes plane_of(const ig::Block& b, const DrillingRun& run) const {
    const double plane = run.mode("DMODE", 0);
    return plane == 1 ? xy_plane : plane == 2 ? zx_plane : plane == 3 ? yz_plane : plane_(b);
  }

  bool resolve(ig::Block& b, DrillingRun& run) const {
    const std::string_view name = run.cycle->name();
    for (const std::string_view needed : {"RTP", "RFP"})
      if (!run[needed]) {
        b.report(ig::diag("SIE-0185"), where(run), name, needed);
        return false;
      }
    run.plane = plane_of(b, run);
    run.hole = last_(b);
    run.retract = *run["RTP"];
    run.reference = *run["RFP"];
    const auto dp = run["DP"], dpr = run["DPR"];
    if (!dp && !dpr) {
      b.report(ig::diag("SIE-0185"), where(run), name, std::string_view("DP or DPR"));
      return false;
    }
    const double absolute = dp.value_or(0), relative = dpr.value_or(0), which = run.mode("AMODE", 0);
    const bool both = dp && dpr && relative != 0;
    const bool is_relative = both ? which != 2 : !dp;
    if (both && which != 1 && which != 2) b.report(ig::diag("SIE-0188"), where(run), name);
    const bool is_down = is_relative ? run.retract > run.reference : absolute <= run.reference;
    run.out = is_down ? 1 : -1;
    run.depth = is_relative ? run.reference - run.out * std::fabs(relative) : absolute;
    run.start = run.reference + run.out * std::fabs(run["SDIS"].value_or(0));
    if ((is_relative && run.retract == run.reference) || run.out * (run.retract - run.reference) < 0) {
      b.report(ig::diag("SIE-0189"), where(run), name, run.retract, run.reference);
      return false;
    }
    for (const double level : {run.depth, run.start})
      if (!(std::fabs(level) < 1e9)) {
        b.report(ig::diag("SIE-0105"), where(run), name);
        return false;
      }
    run.feed = feed.mmds(b);
    const bool has_own_feed = name == "CYCLE85" || name.starts_with("CYCLE84");
    if (run.feed <= 0 && !has_own_feed) b.report(ig::diag("SIE-0186"), where(run), name);
    if (const auto mode = run["GMODE"]; mode && *mode != 0 && name != "CYCLE86")
      b.report(ig::diag("SIE-0190"), where(run), name, *mode);
    if (const auto mode = run["VARI"]; name == "CYCLE82" && mode && *mode != 0)
      b.report(ig::diag("SIE-0191"), where(run), name, *mode);
    run.dwell = seconds(b, run, run["DTB"], run.dwell_unit(1));
    return true;
  }

  void approach(ig::Block& b, DrillingRun& run) const {
    const ig::Vec3 from = last_(b);
    const ig::PartialVec3 named = b.take(words_);
    run.hole = named.or_else(from);
    const bool turns = b.has(angles_[0]) || b.has(angles_[1]) || b.has(angles_[2]);
    if (named.mask == 0 && !turns) return;
    const auto code = b.find(codes_);
    const ig::Symbol term = code ? codes_.name(*code) : b.get_or(state_, codes_.name(0));
    if (term == codes_.name(0)) {
      motion.rapid_to(b, run.hole);
      return;
    }
    if (term != codes_.name(1)) b.report(ig::diag("SIE-0192"), where(run), run.cycle->name());
    motion.feed_to(b, run.hole, feed.mmds(b));
  }

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
