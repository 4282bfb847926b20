// Cycles 200 drilling, 201 reaming, 203 universal drilling and 240 centring, run by CYCL CALL, CYCL CALL POS, M99 and
// M89. A positioning block moves first, then the cycle works where it ended. Every step is an item of CompoundMotion.
#include <numbers>

#include "cycle_parameters.hpp"
#include "klartext_diagnostics.hpp"
#include "peck_strokes.hpp"
#include "plane_util.hpp"
#include "program_xyz_util.hpp"

namespace heidenhain {
namespace {

enum class ReEntry { clearance, fixed };

struct KlartextDrillingCycle {
  static constexpr auto spec =
      ig::syntax("KlartextDrillingCycleSyntax", "Cycles 200, 201, 203 and 240 where they are called.")
          .after("KlartextCycleSyntax", "KlartextMotionSyntax", "UnitModeSyntax", "FeedrateSyntax", "PlaneSelectSyntax")
          .before("MachineCoordSelectSyntax", "ProgramXyzSyntax", "McXyzSyntax", "McAbcSyntax", "LinearMotionSyntax");

  ig::In<bool> call_{
      "KlartextCycle.IsCalled", ig::wake, {ig::Life::block, "", "The block calls the cycle: CYCL CALL, M99 or M89."}};
  ig::In<bool> modal_call_{
      "KlartextCycle.IsModal", ig::wake_while, {ig::Life::modal, "", "M89: each positioning block calls the cycle."}};
  ig::In<bool> at_position_{"KlartextCycle.IsAtPosition",
                            ig::read,
                            {ig::Life::block, "", "CYCL CALL POS: the block goes to the point first."}};
  ig::Signal said_{"CycleDefinition.~Said", ig::read | ig::write, ig::Life::modal};
  ig::In<std::int64_t> number_{
      "CycleDefinition.Number", ig::read, {ig::Life::modal, "", "The cycle that CYCL CALL runs."}};
  CycleDefinition definition_{ig::read};
  ig::Xyz words_{"Parsing", ig::read | ig::take};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Codes motions_{{"G00", "G01"}, ig::read};
  ig::Codes others_{{"G02", "G03", "G53"}, ig::read};
  ig::In<double> feed_{"Feedrate.FeedrateValue"};
  ig::In<ig::Symbol> feed_mode_{"Feedrate.Term"};
  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::CompoundMotion motion_;
  iso::PlaneInForce plane_;
  iso::LastProgramXyz last_;
  ig::Name g95_{"G95"};
  std::array<ig::Name, 4> terms_{ig::Name{"CYCL200"}, ig::Name{"CYCL201"}, ig::Name{"CYCL203"}, ig::Name{"CYCL240"}};
  ig::Choice<ReEntry> re_entry_{"re-entry", "clearance|fixed", "clearance",
                                "How far above the depth reached cycle 200 ends its rapid back into the hole: Q200, or "
                                "the distance of re-entry-distance."};
  ig::NumberOption re_entry_distance_{"re-entry-distance", "0.2", {0, 1000}, "mm", "Of a TNC 426."};
  ig::NumberOption point_angle_{"point-angle",
                                "0",
                                {0, 179},
                                "deg",
                                "T-ANGLE of the drills, for depths that follow from a diameter; 0: not known."};

  ig::Status build(ig::Block& b) {
    const bool is_called = b.has(call_);
    const ig::PartialVec3 named = b.get(words_);
    if (!is_called && (!b.has(modal_call_) || named.mask == 0)) return ig::Status::unchanged;
    const std::int64_t number = b.get_or(number_, std::int64_t{0});
    const std::size_t row = number == 200 ? 0 : number == 201 ? 1 : number == 203 ? 2 : number == 240 ? 3 : 4;
    if (row == 4 || b.find(others_)) {
      refuse(b, number, row != 4);
      return ig::Status::changed;
    }
    Cycle c;
    c.number = static_cast<double>(number);
    c.plane = plane_(b);
    c.hole = last_(b);
    c.offset = b.has(at_position_) ? named.value[c.plane.tool] * (named.has(c.plane.tool) ? 1 : 0) : 0;
    if (!read(b, c)) return ig::Status::changed;
    b.take(words_);
    motion_.begin(b, terms_[row]);
    position(b, c, named);
    to_rapid(b, c, c.safe);
    if (row == 0) drill(b, c);
    if (row == 1) ream(b, c);
    if (row == 2) drill_universally(b, c);
    if (row == 3) centre(b, c);
    if (c.end != c.level) to_rapid(b, c, c.end);
    b.set(program_, c.at(c.level));
    return ig::Status::changed;
  }

 private:
  struct Cycle {
    double number = 0;
    iso::PlaneAxes plane;
    ig::Vec3 hole;
    double offset = 0;  // CYCL CALL POS: the tool axis of the point
    double surface = 0, safe = 0, bottom = 0, end = 0, infeed = 0;
    double feed = 0, retract = 0;  // mm/s; 0: rapid
    double top_dwell = 0, dwell = 0;
    double level = 0;
    ig::Vec3 at(double z) const { return plane.at_level(hole, z); }
  };

  /// Once for each definition.
  void refuse(ig::Block& b, std::int64_t number, bool is_executed) {
    const std::string_view call = b.has(call_) ? "CYCL CALL or M99" : "M89";
    if (is_executed) {
      b.report(hei("HEI-0167"), ig::Where::block(), call);
    } else if (number == 0) {
      b.report(hei("HEI-0162"), ig::Where::block(), call);
    } else if (!b.is_raised(said_)) {
      b.report(hei("HEI-0160"), ig::Where::block(), static_cast<double>(number));
      b.raise(said_);
    }
  }

  /// What the definition says; false, which is said, where the cycle cannot run.
  bool read(ig::Block& b, Cycle& c) const {
    const auto missing = [&](std::string_view what) {
      b.report(hei("HEI-0163"), ig::Where::block(), c.number, what);
      return false;
    };
    const auto clearance = definition_.get(b, 200), plunge = definition_.get(b, 206);
    auto depth = definition_.get(b, 201);
    if (!clearance) return missing("Q200");
    const bool by_diameter = c.number == 240 && definition_.get_or(b, 343, 0) == 1;
    if (by_diameter || definition_.get_or(b, 395, 0) == 1) {
      if (point_angle_ == 0) return missing("the point angle of the tool (option point-angle)");
      const double tangent = std::tan(point_angle_ / 2 * (std::numbers::pi / 180));
      if (by_diameter)
        depth = -std::fabs(definition_.get_or(b, 344, 0)) / 2 / tangent;
      else
        return missing("the diameter of the tool (Q395=1)");
    }
    if (!depth) return missing("Q201");
    if (!plunge) return missing("Q206");
    if (*depth == 0) {
      b.report(hei("HEI-0164"), ig::Where::block(), c.number);
      return false;
    }
    if (*depth > 0) b.report(hei("HEI-0165"), ig::Where::block(), c.number);
    c.feed = in_mmds(b, *plunge);
    if (!(c.feed > 0)) {
      b.report(hei("HEI-0166"), ig::Where::block(), c.number, std::string_view("Q206"), *plunge);
      return false;
    }
    const double retract = definition_.get_or(b, 208, 0);
    c.retract = retract >= fastest ? 0 : retract > 0 ? in_mmds(b, retract) : c.feed;
    c.surface = definition_.get_or(b, 203, 0) + c.offset;
    const double out = *depth > 0 ? -1 : 1;
    c.safe = c.surface + out * std::fabs(*clearance);
    c.bottom = c.surface + *depth;
    const double second = definition_.get_or(b, 204, 0);
    c.end = second > std::fabs(*clearance) ? c.surface + out * second : c.safe;
    c.infeed = std::fabs(definition_.get_or(b, 202, 0));
    c.top_dwell = definition_.get_or(b, 210, 0);
    c.dwell = definition_.get_or(b, 211, 0);
    const iso::PeckStrokes strokes = strokes_of(b, c);
    if (strokes.number() * 5 + 10 <= most_steps) return true;
    b.report(hei("HEI-0166"), ig::Where::block(), c.number, std::string_view("Q202"), c.infeed);
    return false;
  }

  double in_mmds(const ig::Block& b, double feed) const {
    return b.is(feed_mode_, g95_) ? feed * b.get_or(speed_, 0.0) / 60 : feed / 60;
  }

  iso::PeckStrokes strokes_of(const ig::Block& b, const Cycle& c) const {
    const double whole = std::fabs(c.bottom - c.surface);
    const bool pecks = (c.number == 200 || c.number == 203) && c.infeed > 0 && c.infeed < whole;
    if (!pecks) return {c.surface, c.bottom, whole};
    const double less = c.number == 203 ? std::fabs(definition_.get_or(b, 212, 0)) : 0;
    if (less == 0) return {c.surface, c.bottom, c.infeed};
    const double least = std::fabs(definition_.get_or(b, 205, 0));
    // Without a least infeed the last one that is one stays.
    const double floor =
        least > 0 ? std::fmin(least, c.infeed) : c.infeed - less * std::floor((c.infeed - 1e-9) / less);
    return {c.surface, c.bottom, c.infeed, less, floor > 0 ? floor : c.infeed};
  }

  // ---- motions

  void to_rapid(ig::Block& b, Cycle& c, double level) const {
    motion_.rapid_to(b, c.at(level));
    c.level = level;
  }
  void to_feed(ig::Block& b, Cycle& c, double level, double feed) const {
    if (feed > 0)
      motion_.feed_to(b, c.at(level), feed);
    else
      motion_.rapid_to(b, c.at(level));
    c.level = level;
  }

  /// The block's own move, by rapid or by feed. CYCL CALL POS goes to the point by rapid, not below the safe level.
  void position(ig::Block& b, Cycle& c, const ig::PartialVec3& named) const {
    const std::size_t tool = c.plane.tool;
    c.level = c.hole[tool];
    if (named.mask == 0) return;
    ig::Vec3 to = named.or_else(c.hole);
    if (b.has(at_position_)) {
      const bool is_below = (c.safe - c.level) * (c.safe - c.bottom) > 0;
      if (is_below) to_rapid(b, c, c.safe);
      to[tool] = c.level;
    }
    c.hole = to;
    c.level = to[tool];
    const auto code = b.find(motions_);
    const double feed = in_mmds(b, b.get_or(feed_, 0.0));
    if (b.has(at_position_) || (code && *code == 0))
      motion_.rapid_to(b, to);
    else
      motion_.feed_to(b, to, feed);
  }

  void drill(ig::Block& b, Cycle& c) const {
    const iso::PeckStrokes strokes = strokes_of(b, c);
    const int count = static_cast<int>(strokes.number());
    for (int k = 1; k <= count; ++k) {
      const double level = strokes.level(k, count);
      to_feed(b, c, level, c.feed);
      if (k == count) break;
      to_rapid(b, c, c.safe);
      if (c.top_dwell > 0) motion_.dwell(b, c.top_dwell);
      const double above = re_entry_ == ReEntry::clearance ? std::fabs(c.safe - c.surface) : double{re_entry_distance_};
      to_rapid(b, c, inside(c, strokes.above(level, above)));
    }
    if (c.dwell > 0) motion_.dwell(b, c.dwell);
    to_rapid(b, c, c.end);
  }

  void ream(ig::Block& b, Cycle& c) const {
    to_feed(b, c, c.bottom, c.feed);
    if (c.dwell > 0) motion_.dwell(b, c.dwell);
    to_feed(b, c, c.safe, c.retract);
  }

  void drill_universally(ig::Block& b, Cycle& c) const {
    const iso::PeckStrokes strokes = strokes_of(b, c);
    const int count = static_cast<int>(strokes.number());
    const double breaks = definition_.get_or(b, 213, 0), retract = std::fabs(definition_.get_or(b, 256, 0));
    double made = 0;
    for (int k = 1; k <= count; ++k) {
      const double level = strokes.level(k, count);
      to_feed(b, c, level, c.feed);
      if (k == count) break;
      if (made < breaks) {
        made += 1;
        to_rapid(b, c, inside(c, strokes.above(level, retract)));
        continue;
      }
      made = 0;
      to_feed(b, c, c.safe, c.retract);
      if (c.top_dwell > 0) motion_.dwell(b, c.top_dwell);
      const double above = breaks > 0 ? retract : std::fabs(c.safe - c.surface);
      to_rapid(b, c, inside(c, strokes.above(level, above)));
    }
    if (c.dwell > 0) motion_.dwell(b, c.dwell);
    to_feed(b, c, c.safe, c.retract);
  }

  void centre(ig::Block& b, Cycle& c) const {
    to_feed(b, c, c.bottom, c.feed);
    if (c.dwell > 0) motion_.dwell(b, c.dwell);
    to_rapid(b, c, c.end);
  }

  /// Not beyond the safe level.
  static double inside(const Cycle& c, double level) {
    return c.safe >= c.bottom ? std::fmin(level, c.safe) : std::fmax(level, c.safe);
  }

  static constexpr double fastest = 99'999;
  static constexpr double most_steps = 100'000;
};

const ig::Register<KlartextDrillingCycle> registered;

}  // namespace
}  // namespace heidenhain
