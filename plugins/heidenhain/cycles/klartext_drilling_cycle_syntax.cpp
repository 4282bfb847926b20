// Cycles 200, drilling, 201, reaming, 203, universal drilling, and 240, centring, run by CYCL CALL, CYCL CALL POS, M99,
// M89 and the patterns 220 and 221. A positioning block moves first, then the cycle runs at its end point. Every step
// is an item of CompoundMotion.
#include <numbers>

#include <isogloss/cnc/peck_strokes.hpp>
#include <isogloss/cnc/units.hpp>

#include "cycles/hole_cycle.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

enum class ReEntry { clearance, fixed };

struct KlartextDrillingCycle {
  static constexpr auto spec =
      hole_cycle("KlartextDrillingCycleSyntax", "Cycles 200, 201, 203 and 240 where they are called.");

  HoleCycle cycle_{{200, "CYCL200"}, {201, "CYCL201"}, {203, "CYCL203"}, {240, "CYCL240"}};
  ig::Choice<ReEntry> re_entry_{"re-entry", "clearance|fixed", "clearance",
                                "How far above the depth reached cycle 200 ends its rapid back into the hole: Q200, or "
                                "the distance of re-entry-distance."};
  ig::NumberOption re_entry_distance_{
      "re-entry-distance", "0.2", {0, 1000}, "mm", "The distance of the re-entry on a TNC 426."};
  ig::NumberOption point_angle_{"point-angle",
                                "0",
                                {0, 179},
                                "deg",
                                "T-ANGLE of the drills, for depths that follow from a diameter; 0: not known."};

  ig::Status build(ig::Block& b) const { return cycle_.run(b, *this); }

  std::optional<double> prepare(ig::Block& b, HoleRun& c) const {
    const auto depth = depth_of(b, c);
    if (!depth || !cycle_.levels(b, c, *depth) || !cycle_.feeds(b, c)) return std::nullopt;
    return strokes_of(b, c).number() * 5 + 10;
  }

  void machine(ig::Block& b, HoleRun& c) const {
    switch (c.number) {
      case 200: return drill(b, c);
      case 201: return ream(b, c);
      case 203: return drill_universally(b, c);
      default: return centre(b, c);
    }
  }

 private:
  std::optional<double> depth_of(ig::Block& b, const HoleRun& c) const {
    const auto missing = [&](std::string_view what) {
      b.report(ig::diag("HEI-0163"), ig::Where::block(), static_cast<double>(c.number), what);
      return std::nullopt;
    };
    const bool by_diameter = c.number == 240 && cycle_.get_or(b, 343, 0) == 1;
    if (!by_diameter && cycle_.get_or(b, 395, 0) != 1) return cycle_.needed(b, c, 201);
    if (point_angle_ == 0) return missing("the point angle of the tool (option point-angle)");
    if (!by_diameter) return missing("the diameter of the tool (Q395=1)");
    const auto diameter = cycle_.needed(b, c, 344);
    if (!diameter) return std::nullopt;
    return -std::fabs(*diameter) / 2 / std::tan(point_angle_ / 2 * radians_per_degree);
  }

  PeckStrokes strokes_of(const ig::Block& b, const HoleRun& c) const {
    const double whole = std::fabs(c.bottom - c.surface), infeed = std::fabs(cycle_.get_or(b, 202, 0));
    const bool pecks = (c.number == 200 || c.number == 203) && infeed > 0 && infeed < whole;
    if (!pecks) return {c.surface, c.bottom, whole};
    return c.number == 203 ? cycle_.shrinking_strokes(b, c, infeed) : PeckStrokes{c.surface, c.bottom, infeed};
  }

  void drill(ig::Block& b, HoleRun& c) const {
    const PeckStrokes strokes = strokes_of(b, c);
    const int count = static_cast<int>(strokes.number());
    for (int k = 1; k <= count; ++k) {
      const double level = strokes.level(k, count);
      cycle_.feed_to(b, c, level, c.feed);
      if (k == count) break;
      cycle_.rapid_to(b, c, c.safe);
      cycle_.dwell(b, cycle_.get_or(b, 210, 0));
      const double above = re_entry_ == ReEntry::clearance ? c.clearance : double{re_entry_distance_};
      cycle_.rapid_to(b, c, c.inside(strokes.above(level, above)));
    }
    cycle_.dwell(b, c.dwell);
    cycle_.rapid_to(b, c, c.end);
  }

  void ream(ig::Block& b, HoleRun& c) const {
    cycle_.feed_to(b, c, c.bottom, c.feed);
    cycle_.dwell(b, c.dwell);
    cycle_.feed_to(b, c, c.safe, c.retract);
    cycle_.leave(b, c);
  }

  void drill_universally(ig::Block& b, HoleRun& c) const {
    const PeckStrokes strokes = strokes_of(b, c);
    const int count = static_cast<int>(strokes.number());
    const double breaks = cycle_.get_or(b, 213, 0), retract = std::fabs(cycle_.get_or(b, 256, 0));
    double made = 0;
    for (int k = 1; k <= count; ++k) {
      const double level = strokes.level(k, count);
      cycle_.feed_to(b, c, level, c.feed);
      if (k == count) break;
      if (made < breaks) {
        made += 1;
        cycle_.rapid_to(b, c, c.inside(strokes.above(level, retract)));
        continue;
      }
      made = 0;
      cycle_.feed_to(b, c, c.safe, c.retract);
      cycle_.dwell(b, cycle_.get_or(b, 210, 0));
      cycle_.rapid_to(b, c, c.inside(strokes.above(level, breaks > 0 ? retract : c.clearance)));
    }
    cycle_.dwell(b, c.dwell);
    cycle_.feed_to(b, c, c.safe, c.retract);
    cycle_.leave(b, c);
  }

  void centre(ig::Block& b, HoleRun& c) const {
    cycle_.feed_to(b, c, c.bottom, c.feed);
    cycle_.dwell(b, c.dwell);
    cycle_.rapid_to(b, c, c.end);
  }
};

const ig::Register<KlartextDrillingCycle> klartext_drilling_cycle_syntax;

}  // namespace
}  // namespace heidenhain
