// Cycles 1, pecking, 2, tapping, and 17, rigid tapping, of older controls. They start at the tool's position at the
// call, which is SET UP above the surface, and end there.
#include <algorithm>

#include "cycles/hole_cycle.hpp"
#include "cycles/hole_spindle.hpp"
#include "language/program_unit.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextOldCycle {
  static constexpr auto spec =
      hole_cycle("KlartextOldCycleSyntax", "Cycles 1, 2 and 17 of older controls where they are called.");

  HoleCycle cycle_{{1, "CYCL1"}, {2, "CYCL2"}, {17, "CYCL17"}};
  HoleSpindle spindle_;
  ProgramUnit unit_;
  FeedUnit feed_unit_;

  ig::Status build(ig::Block& b) { return cycle_.run(b, *this); }

  bool find_surface(ig::Block& b, HoleRun& c) const {
    const auto clearance = needed(b, c, 1), depth = needed(b, c, 2);
    if (!clearance || !depth) return false;
    c.clearance = std::fabs(*clearance) * unit_.in_mm(b);
    c.surface = c.level + (*depth > 0 ? 1 : -1) * c.clearance;
    return true;
  }

  std::optional<double> prepare(ig::Block& b, HoleRun& c) const {
    if (!cycle_.levels(b, c, *cycle_.get(b, 2) * unit_.in_mm(b))) return std::nullopt;
    const auto third = needed(b, c, 3);
    if (!third) return std::nullopt;
    if (c.number == 17) {
      c.feed = cycle_.speed(b) * std::fabs(*third) * unit_.in_mm(b) / 60;
      return has_feed(b, c, *third == 0 ? "PITCH" : "the speed S", *third == 0 ? *third : cycle_.speed(b), 8);
    }
    const std::uint32_t feed = c.number == 1 ? 5 : 4;
    const auto f = needed(b, c, feed);
    if (!f) return std::nullopt;
    c.feed = cycle_.in_mmds(b, feed_unit_.in_mm(b, *f));
    c.dwell = c.number == 1 ? cycle_.get_or(b, 4, 0) : *third;
    return has_feed(b, c, "F", *f, c.number == 1 ? strokes_of(b, c).number() * 3 + 8 : 8);
  }

  void begin(ig::Block& b, const HoleRun& c) {
    if (c.number == 1) return;
    const bool is_left = c.number == 17 ? cycle_.get_or(b, 3, 0) < 0 : spindle_.turns_ccw(b);
    in_ = is_left ? ig::Spindle::ccw : ig::Spindle::cw;
    spindle_.leave(b, cycle_.motion, c.number == 17 ? ig::Spindle::stop : in_);
  }

  void machine(ig::Block& b, HoleRun& c) const {
    if (c.number == 1) return peck(b, c);
    cycle_.motion.spindle(b, in_);
    cycle_.feed_to(b, c, c.bottom, c.feed);
    cycle_.dwell(b, c.dwell);
    cycle_.motion.spindle(b, HoleSpindle::other(in_));
    cycle_.feed_to(b, c, c.safe, c.feed);
    cycle_.motion.spindle(b, c.number == 17 ? ig::Spindle::stop : in_);
  }

 private:
  ig::Spindle in_ = ig::Spindle::cw;  // of the block

  std::optional<double> needed(ig::Block& b, const HoleRun& c, std::uint32_t part) const {
    static constexpr std::array<std::array<std::string_view, 5>, 3> names{{{"SET UP", "DEPTH", "PECKING", "DWELL", "F"},
                                                                           {"SET UP", "DEPTH", "DWELL", "F", ""},
                                                                           {"SET UP", "DEPTH", "PITCH", "", ""}}};
    const auto value = cycle_.get(b, part);
    const std::size_t cycle = c.number == 1 ? 0 : c.number == 2 ? 1 : 2;
    if (!value)
      b.report(ig::diag("HEI-0163"), ig::Where::block(), static_cast<double>(c.number), names[cycle][part - 1]);
    return value;
  }
  static std::optional<double> has_feed(ig::Block& b, const HoleRun& c, std::string_view what, double value,
                                        double steps) {
    if (c.feed > 0) return steps;
    b.report(ig::diag("HEI-0166"), ig::Where::block(), static_cast<double>(c.number), what, value);
    return std::nullopt;
  }

  PeckStrokes strokes_of(const ig::Block& b, const HoleRun& c) const {
    const double whole = std::fabs(c.bottom - c.surface), infeed = std::fabs(cycle_.get_or(b, 3, 0)) * unit_.in_mm(b);
    return {c.surface, c.bottom, infeed > 0 && infeed < whole ? infeed : whole};
  }

  void peck(ig::Block& b, HoleRun& c) const {
    const PeckStrokes strokes = strokes_of(b, c);
    const int count = static_cast<int>(strokes.number());
    const double whole = std::fabs(c.bottom - c.surface);
    const double ahead = std::clamp(whole / 50, 0.6, 7.0);
    for (int k = 1; k <= count; ++k) {
      const double level = strokes.level(k, count);
      cycle_.feed_to(b, c, level, c.feed);
      if (k == count) break;
      cycle_.rapid_to(b, c, c.safe);
      cycle_.rapid_to(b, c, c.inside(strokes.above(level, ahead)));
    }
    cycle_.dwell(b, c.dwell);
    cycle_.rapid_to(b, c, c.safe);
  }
};

const ig::Register<KlartextOldCycle> klartext_old_cycle_syntax;

}  // namespace
}  // namespace heidenhain
