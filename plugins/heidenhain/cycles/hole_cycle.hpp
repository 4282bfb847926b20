/// What the cycles for holes share: their call, the levels along the tool axis, and the way to each hole.
#pragma once

#include <algorithm>
#include <vector>

#include <isogloss/cnc/peck_strokes.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/sdk.hpp>

#include "cycles/cycle_parameters.hpp"
#include "cycles/hole_pattern.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// The spec of a syntax of such cycles, with its place in the chain: after everything that determines position, feed
/// and plane, before the computation of machine positions.
constexpr auto hole_cycle(const char* id, const char* summary) {
  return ig::syntax(id, summary)
      .after("KlartextCycleSyntax", "KlartextMotionSyntax", "UnitModeSyntax", "FeedrateSyntax", "PlaneSelectSyntax",
             "SpindleSpeedSyntax")
      .before("KlartextCycleCheckSyntax", "MachineCoordSelectSyntax", "ProgramXyzSyntax", "McXyzSyntax", "McAbcSyntax",
              "LinearMotionSyntax");
}

/// A cycle that is being executed. Levels are positions on the tool axis in mm; feeds are in mm/s, 0 is a rapid.
struct HoleRun {
  std::int64_t number = 0;
  PlaneAxes plane;
  ig::Vec3 hole;      ///< its component along the tool axis is not used
  double offset = 0;  ///< CYCL CALL POS: the point's coordinate along the tool axis
  double surface = 0, clearance = 0, safe = 0, bottom = 0, end = 0;
  double feed = 0, retract = 0;
  double dwell = 0;
  double level = 0;  ///< present level of the tool

  ig::Vec3 at(double z) const { return plane.at_level(hole, z); }
  /// 1 where the tool leaves the hole in the positive direction of the tool axis, else -1.
  double out() const { return safe >= bottom ? 1 : -1; }
  /// `z`, limited to the safe level.
  double inside(double z) const { return out() > 0 ? std::fmin(z, safe) : std::fmax(z, safe); }
};

/// A member of each syntax that executes such cycles.
class HoleCycle {
 public:
  struct Cycle {
    std::int64_t number;
    const char* term;
  };
  explicit HoleCycle(std::initializer_list<Cycle> cycles) {
    for (const Cycle& c : cycles) cycles_.push_back({c.number, ig::Name{c.term}});
  }

  static constexpr double most_steps = 100'000;

  /// Executes a call of one of the cycles in this block. `self.prepare(b, run)` reads the cycle's own parameters and
  /// returns the number of steps of one hole; nothing, with a diagnostic, where the cycle cannot run, and the block
  /// then moves as without the call. `self.begin(b, run)` is called before all holes, `self.machine(b, run)` makes the
  /// steps of one hole from above it. Where `self.find_surface(b, run)` exists, it finds surface and clearance in place
  /// of Q203 and Q200; `run.level` is then the present level of the tool.
  template <class Self>
  ig::Status run(ig::Block& b, Self& self) const {
    const bool is_called = b.has(call_);
    const ig::PartialVec3 named = b.get(words_);
    if (!is_called && (!b.has(modal_call_) || named.mask == 0)) return ig::Status::unchanged;
    const std::int64_t number = b.get_or(number_, std::int64_t{0});
    const auto cycle = std::find_if(cycles_.begin(), cycles_.end(), [&](const Term& t) { return t.number == number; });
    if (cycle == cycles_.end() || b.find(others_)) return ig::Status::unchanged;
    if (number < 100 && pattern_.is_set(b))
      return ig::Status::unchanged;  // a pattern calls cycles with numbers from 200
    b.raise(done_);
    HoleRun c;
    c.number = number;
    c.plane = plane_(b);
    c.hole = last_(b);
    c.offset = b.has(at_position_) ? named.value[c.plane.tool] * (named.has(c.plane.tool) ? 1 : 0) : 0;
    const HolePattern::Points points = pattern_(b, c.plane);
    c.level = named.or_else(c.hole)[c.plane.tool];
    bool has_surface = false;
    if constexpr (requires { self.find_surface(b, c); })
      has_surface = self.find_surface(b, c);
    else
      has_surface = find_surface(b, c);
    const std::optional<double> steps = has_surface ? self.prepare(b, c) : std::nullopt;
    if (!steps) return ig::Status::changed;
    if (points.count == 0) {
      b.report(ig::diag("HEI-0183"), ig::Where::block());
      return ig::Status::changed;
    }
    if (!(*steps * static_cast<double>(points.count) <= most_steps)) {
      b.report(ig::diag("HEI-0177"), ig::Where::block(), static_cast<double>(number), most_steps);
      return ig::Status::changed;
    }
    b.take(words_);
    motion.begin(b, cycle->term);
    if constexpr (requires { self.begin(b, c); }) self.begin(b, c);
    if (points.is_pattern) {
      machine_all(b, self, c, points);
    } else {
      position(b, c, named);
      rapid_to(b, c, c.safe);
      self.machine(b, c);
    }
    b.set(program_, c.at(c.level));
    return ig::Status::changed;
  }

  // ---- parameters

  std::optional<double> get(const ig::Block& b, std::uint32_t q) const {
    const auto of_pattern = pattern_.get(b, q);
    return of_pattern ? of_pattern : definition_.get(b, q);
  }
  double get_or(const ig::Block& b, std::uint32_t q, double fallback) const { return get(b, q).value_or(fallback); }
  std::optional<double> needed(ig::Block& b, const HoleRun& c, std::uint32_t q) const {
    const auto value = get(b, q);
    if (!value) b.report(ig::diag("HEI-0163"), ig::Where::block(), static_cast<double>(c.number), name(q));
    return value;
  }
  /// A feed in mm/s; 0, with a diagnostic, where there is none.
  double feed(ig::Block& b, const HoleRun& c, std::uint32_t q) const {
    const auto value = needed(b, c, q);
    if (!value) return 0;
    const double mmds = in_mmds(b, *value);
    if (mmds > 0) return mmds;
    b.report(ig::diag("HEI-0166"), ig::Where::block(), static_cast<double>(c.number), name(q), *value);
    return 0;
  }
  double in_mmds(const ig::Block& b, double feed) const {
    return b.is(feed_mode_, g95_) ? feed * speed(b) / 60 : feed / 60;
  }
  double speed(const ig::Block& b) const { return b.get_or(speed_, 0.0); }

  /// Q201, the feed Q206, Q208 and Q211: levels, feeds and dwell of most cycles.
  bool drills(ig::Block& b, HoleRun& c) const {
    const auto depth = needed(b, c, 201);
    return depth && levels(b, c, *depth) && feeds(b, c);
  }
  /// `depth` is signed like Q201: negative is downwards.
  bool levels(ig::Block& b, HoleRun& c, double depth) const {
    if (depth == 0) {
      b.report(ig::diag("HEI-0164"), ig::Where::block(), static_cast<double>(c.number));
      return false;
    }
    if (depth > 0) b.report(ig::diag("HEI-0165"), ig::Where::block(), static_cast<double>(c.number));
    const double out = depth > 0 ? -1 : 1;
    c.safe = c.surface + out * c.clearance;
    c.bottom = c.surface + depth;
    const double second = get_or(b, 204, 0);
    c.end = second > c.clearance ? c.surface + out * second : c.safe;
    return true;
  }
  bool feeds(ig::Block& b, HoleRun& c) const {
    c.feed = feed(b, c, 206);
    const double retract = get_or(b, 208, 0);
    c.retract = retract >= fastest ? 0 : retract > 0 ? in_mmds(b, retract) : c.feed;
    c.dwell = get_or(b, 211, 0);
    return c.feed > 0;
  }

  /// Strokes from the surface, each smaller than the one before by Q212, but not smaller than Q205.
  PeckStrokes shrinking_strokes(const ig::Block& b, const HoleRun& c, double infeed) const {
    const double less = std::fabs(get_or(b, 212, 0));
    if (less == 0) return {c.surface, c.bottom, infeed};
    const double least = std::fabs(get_or(b, 205, 0));
    // Without a least infeed, the last positive infeed is repeated.
    const double floor = least > 0 ? std::fmin(least, infeed) : infeed - less * std::floor((infeed - 1e-9) / less);
    return {c.surface, c.bottom, infeed, less, floor > 0 ? floor : infeed};
  }

  // ---- steps

  void rapid_to(ig::Block& b, HoleRun& c, double level) const {
    motion.rapid_to(b, c.at(level));
    c.level = level;
  }
  /// `feed` in mm/s; 0: a rapid.
  void feed_to(ig::Block& b, HoleRun& c, double level, double feed) const {
    if (feed > 0)
      motion.feed_to(b, c.at(level), feed);
    else
      motion.rapid_to(b, c.at(level));
    c.level = level;
  }
  void dwell(ig::Block& b, double seconds) const {
    if (seconds > 0) motion.dwell(b, seconds);
  }
  /// Retracts to the second set-up clearance (or the first), unless the tool is there already.
  void leave(ig::Block& b, HoleRun& c) const {
    if (c.end != c.level) rapid_to(b, c, c.end);
  }

  ig::CompoundMotion motion;
  static constexpr double fastest = 99'999;

 private:
  struct Term {
    std::int64_t number;
    ig::Name term;
  };

  static std::string_view name(std::uint32_t q) { return cycle_parameters[index_of_parameter(q)].name; }

  bool find_surface(ig::Block& b, HoleRun& c) const {
    const auto clearance = needed(b, c, 200);
    if (!clearance) return false;
    c.clearance = std::fabs(*clearance);
    c.surface = get_or(b, 203, 0) + c.offset;
    return true;
  }

  /// The block's own move, by rapid or by feed. CYCL CALL POS goes to its point by rapid, not below the safe level.
  void position(ig::Block& b, HoleRun& c, const ig::PartialVec3& named) const {
    const std::size_t tool = c.plane.tool;
    c.level = c.hole[tool];
    if (named.mask == 0) return;
    ig::Vec3 to = named.or_else(c.hole);
    if (b.has(at_position_)) {
      const bool is_below = (c.safe - c.level) * (c.safe - c.bottom) > 0;
      if (is_below) rapid_to(b, c, c.safe);
      to[tool] = c.level;
    }
    c.hole = to;
    c.level = to[tool];
    const auto code = b.find(motions_);
    if (b.has(at_position_) || (code && *code == 0))
      motion.rapid_to(b, to);
    else
      motion.feed_to(b, to, in_mmds(b, b.get_or(feed_, 0.0)));
  }

  /// Cycles 220 and 221: to the first point at the second set-up clearance, and from hole to hole at the first or the
  /// second one.
  template <class Self>
  void machine_all(ig::Block& b, const Self& self, HoleRun& c, const HolePattern::Points& points) const {
    if (points.list != nullptr) return machine_list(b, self, c, points);
    const double end = c.end;
    c.level = c.hole[c.plane.tool];
    rapid_to(b, c, end);
    for (std::int64_t i = 0; i < points.count; ++i) {
      c.hole = pattern_.point(b, points, c.plane, c.hole, i);
      motion.rapid_to(b, c.at(c.level));
      rapid_to(b, c, c.safe);
      c.end = points.is_high || i + 1 == points.count ? end : c.safe;
      self.machine(b, c);
    }
  }

  /// CYCL CALL PAT: between the points the tool stays at its level at the call, or at the second set-up clearance where
  /// that is higher. Each point adds its own height to the surface.
  template <class Self>
  void machine_list(ig::Block& b, const Self& self, HoleRun& c, const HolePattern::Points& points) const {
    const double at_call = c.hole[c.plane.tool];
    double end = c.end, added = 0;
    c.level = at_call;
    const auto code = b.find(motions_);
    const double between = code && *code == 0 ? 0 : in_mmds(b, b.get_or(feed_, 0.0));
    for (std::int64_t i = 0; i < points.count; ++i) {
      const double more = (*points.list)[static_cast<std::size_t>(i)].surface - added;
      added += more;
      for (double* const level : {&c.surface, &c.safe, &c.bottom, &end}) *level += more;
      const double high = c.out() > 0 ? std::fmax(at_call, end) : std::fmin(at_call, end);
      if (c.level != high) rapid_to(b, c, high);
      c.hole = pattern_.point(b, points, c.plane, c.hole, i);
      feed_to(b, c, high, between);
      rapid_to(b, c, c.safe);
      c.end = high;
      self.machine(b, c);
    }
  }

  std::vector<Term> cycles_;
  ig::In<bool> call_{
      "KlartextCycle.IsCalled", ig::wake, {ig::Life::block, "", "The block calls the cycle: CYCL CALL, M99 or M89."}};
  ig::In<bool> modal_call_{
      "KlartextCycle.IsModal", ig::wake_while, {ig::Life::modal, "", "M89: each positioning block calls the cycle."}};
  ig::In<bool> at_position_{"KlartextCycle.IsAtPosition",
                            ig::read,
                            {ig::Life::block, "", "CYCL CALL POS: the block goes to the point first."}};
  ig::Signal done_{"KlartextCycle.~Done", ig::write};
  ig::In<std::int64_t> number_{
      "CycleDefinition.Number", ig::read, {ig::Life::modal, "", "The cycle that CYCL CALL runs."}};
  CycleDefinition definition_{ig::read};
  HolePattern pattern_{ig::read};
  ig::Xyz words_{"Parsing", ig::read | ig::take};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Codes motions_{{"G00", "G01"}, ig::read};
  ig::Codes others_{{"G02", "G03", "G53"}, ig::read};
  ig::In<double> feed_{"Feedrate.FeedrateValue"};
  ig::In<ig::Symbol> feed_mode_{"Feedrate.Term"};
  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  PlaneInForce plane_;
  LastProgramXyz last_;
  ig::Name g95_{"G95"};
};

/// The spindle in a cycle that turns it itself.
class CycleSpindle {
 public:
  bool turns_ccw(const ig::Block& b) const { return b.is(direction_, ccw_); }
  bool turns(const ig::Block& b) const { return b.is(direction_, ccw_) || b.is(direction_, cw_); }
  static ig::Spindle other(ig::Spindle direction) {
    return direction == ig::Spindle::cw ? ig::Spindle::ccw : ig::Spindle::cw;
  }
  bool is(const ig::Block& b, ig::Spindle direction) const { return b.is(direction_, name(direction)); }

  /// Before the first step of a cycle that leaves the spindle turning as `last`: an M function of the block acts before
  /// the cycle, so it becomes a step, unless the order of events within a block gives the same result.
  void leave(ig::Block& b, const ig::CompoundMotion& motion, ig::Spindle last) const {
    const auto now = b.get(direction_);
    const bool stays = now && *now == name(last);
    if (now && b.is_fresh(direction_) && (!stays || *now == stop_)) {
      motion.spindle(b, *now == cw_ ? ig::Spindle::cw : *now == ccw_ ? ig::Spindle::ccw : ig::Spindle::stop);
      if (!stays) b.erase(direction_);
    }
    if (!stays) b.amend(direction_, name(last));
  }

 private:
  ig::Symbol name(ig::Spindle direction) const {
    return direction == ig::Spindle::cw ? cw_ : direction == ig::Spindle::ccw ? ccw_ : stop_;
  }
  ig::Out<ig::Symbol> direction_{"SpindleSpeed.Direction"};
  ig::Name cw_{"CW"}, ccw_{"CCW"}, stop_{"STOP"};
};

}  // namespace heidenhain
