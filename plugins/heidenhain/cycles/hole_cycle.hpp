/// What the cycles for holes share: their call, the levels along the tool axis, and the way to each hole.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include <isogloss/cnc/feed.hpp>
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
    std::optional<Call> call = called(b);
    if (!call) return ig::Status::unchanged;
    HoleRun& c = call->hole;
    bool has_surface = false;
    if constexpr (requires { self.find_surface(b, c); })
      has_surface = self.find_surface(b, c);
    else
      has_surface = find_surface(b, c);
    const std::optional<double> steps = has_surface ? self.prepare(b, c) : std::nullopt;
    if (!steps || !begin_steps(b, *call, *steps)) return ig::Status::changed;
    if constexpr (requires { self.begin(b, c); }) self.begin(b, c);
    for (std::int64_t i = 0; go_to(b, *call, i); ++i) self.machine(b, c);
    b.set(program_, c.at(c.level));
    return ig::Status::changed;
  }

  // ---- parameters

  std::optional<double> get(const ig::Block& b, std::uint32_t q) const;
  double get_or(const ig::Block& b, std::uint32_t q, double fallback) const { return get(b, q).value_or(fallback); }
  /// Nothing, with a diagnostic, where the definition lacks the parameter.
  std::optional<double> needed(ig::Block& b, const HoleRun& c, std::uint32_t q) const;
  /// A feed in mm/s; 0, with a diagnostic, where there is none.
  double feed(ig::Block& b, const HoleRun& c, std::uint32_t q) const;
  double in_mmds(const ig::Block& b, double feed) const;
  double speed(const ig::Block& b) const { return b.get_or(speed_, 0.0); }

  /// Q201, the feed Q206, Q208 and Q211: levels, feeds and dwell of most cycles. False, with a diagnostic, where one is
  /// missing.
  bool drills(ig::Block& b, HoleRun& c) const;
  /// `depth` is signed like Q201: negative is downwards. False, with a diagnostic, where it is 0.
  bool levels(ig::Block& b, HoleRun& c, double depth) const;
  bool feeds(ig::Block& b, HoleRun& c) const;

  /// Strokes from the surface, each smaller than the one before by Q212, but not smaller than Q205.
  PeckStrokes shrinking_strokes(const ig::Block& b, const HoleRun& c, double infeed) const;

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

 private:
  struct Term {
    std::int64_t number;
    ig::Name term;
  };

  /// A call of one of the cycles, and what its holes have in common.
  struct Call {
    HoleRun hole;
    ig::Symbol term;
    ig::PartialVec3 named;  ///< the words X, Y and Z of the block
    HolePattern::Points points;
    // From hole to hole:
    double at_call = 0;                                                  ///< level of the tool before the first hole
    double end = 0;                                                      ///< level behind the last hole
    double added = 0;                                                    ///< height of the present point of PATTERN DEF
    double clearance_before = std::numeric_limits<double>::quiet_NaN();  ///< CLEARANCE of the point before; NaN: none
    std::optional<double> feed_mmds{};  ///< feed between the points of PATTERN DEF; none: by rapid
  };

  /// Nothing where the block calls none of the cycles.
  std::optional<Call> called(ig::Block& b) const;
  bool find_surface(ig::Block& b, HoleRun& c) const;
  /// Takes the words of the block and begins its steps; false, with a diagnostic, where there are no holes, or too
  /// many.
  bool begin_steps(ig::Block& b, const Call& call, double steps_of_hole) const;

  // ---- hole_route.cpp

  /// Moves to the safe level above hole `i`; false behind the last one.
  bool go_to(ig::Block& b, Call& call, std::int64_t i) const;
  /// The block's own move, by rapid or by feed. CYCL CALL POS goes to its point not below the safe level.
  void position(ig::Block& b, Call& call) const;
  /// The feed in force in mm/s; 0, with a diagnostic, where there is none.
  double feed_of_way(ig::Block& b) const;
  /// Cycles 220 and 221: to the first point at the second set-up clearance, and from hole to hole at the first or the
  /// second one.
  void go_along_pattern(ig::Block& b, Call& call, std::int64_t i) const;
  /// CYCL CALL PAT: between the points the tool stays at its level at the call, or at the second set-up clearance where
  /// that is higher. Each point adds its own height to the surface.
  void go_along_list(ig::Block& b, Call& call, std::int64_t i) const;

  std::vector<Term> cycles_;
  ig::In<bool> call_{
      "KlartextCycle.IsCalled", ig::wake, {ig::Life::block, "", "The block calls the cycle: CYCL CALL, M99 or M89."}};
  ig::In<bool> modal_call_{
      "KlartextCycle.IsModal", ig::wake_while, {ig::Life::modal, "", "M89: each positioning block calls the cycle."}};
  ig::In<bool> at_position_{"KlartextCycle.IsAtPosition",
                            ig::read,
                            {ig::Life::block, "", "CYCL CALL POS: the block goes to the point first."}};
  ig::In<double> way_feed_{"KlartextCycle.WayFeed",
                           ig::read,
                           {ig::Life::block, "", "F of CYCL CALL POS, for the way to its point: mm/min, or mm/rev."}};
  ig::In<bool> way_per_revolution_{
      "KlartextCycle.IsWayPerRevolution", ig::read, {ig::Life::block, "", "WayFeed is mm/rev."}};
  ig::Signal done_{"KlartextCycle.~Done", ig::read | ig::write};
  ig::In<std::int64_t> number_{
      "CycleDefinition.Number", ig::read, {ig::Life::modal, "", "The cycle that CYCL CALL runs."}};
  CycleDefinition definition_{ig::read};
  HolePattern pattern_{ig::read};
  ig::Xyz words_{"Parsing", ig::read | ig::take};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Codes motions_{{"G00", "G01"}, ig::read};
  ig::Codes others_{{"G02", "G03", "G53"}, ig::read};
  ig::In<double> feed_{"Feedrate.FeedrateValue"};
  FeedInForce in_force_;
  ig::In<ig::Symbol> feed_mode_{"Feedrate.Term"};
  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  PlaneInForce plane_;
  LastProgramXyz last_;
  ig::Name g95_{"G95"};
};

}  // namespace heidenhain
