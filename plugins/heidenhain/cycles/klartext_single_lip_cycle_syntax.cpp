// Cycle 241, deep drilling with a single-lip drill: into an existing hole by a feed of its own, then to the depth, in
// infeeds where Q202 gives one. The tool leaves the hole by feed.
#include "cycles/hole_cycle.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextSingleLipCycle {
  static constexpr auto spec =
      hole_cycle("KlartextSingleLipCycleSyntax", "Cycle 241 single-lip deep drilling where it is called.");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "HEI-0188", "cycle {0} does not change the spindle speed or the coolant here: {1}"),
  };

  HoleCycle cycle_{{241, "CYCL241"}};
  ig::Signal said_{"CycleDefinition.~Said", ig::read | ig::write, ig::Life::modal};

  ig::Status build(ig::Block& b) const { return cycle_.run(b, *this); }

  std::optional<double> prepare(ig::Block& b, HoleRun& c) const {
    if (!cycle_.drills(b, c)) return std::nullopt;
    if (cycle_.get_or(b, 379, 0) != 0 && cycle_.feed(b, c, 253) == 0) return std::nullopt;
    if (!b.is_raised(said_))
      b.report(ig::diag("HEI-0188"), ig::Where::block(), 241.0, std::string_view("Q426 to Q430 have no effect"));
    b.raise(said_);
    return strokes_of(b, c).number() * 2 + 8;
  }

  void machine(ig::Block& b, HoleRun& c) const {
    if (cycle_.get_or(b, 379, 0) != 0) cycle_.feed_to(b, c, start_of(b, c), cycle_.feed(b, c, 253));
    const PeckStrokes strokes = strokes_of(b, c);
    const int count = static_cast<int>(strokes.number());
    for (int k = 1; k <= count; ++k) {
      drill_to(b, c, strokes.level(k, count));
      cycle_.dwell(b, c.dwell);
    }
    cycle_.feed_to(b, c, c.safe, c.retract);
    cycle_.leave(b, c);
  }

 private:
  /// The set-up clearance above the level where the drill begins to cut.
  double start_of(const ig::Block& b, const HoleRun& c) const {
    const double depth = std::fabs(cycle_.get_or(b, 379, 0)) - c.clearance;
    return c.inside(c.surface - c.out() * std::fmin(depth, std::fabs(c.bottom - c.surface)));
  }

  /// Below the dwell depth the feed is Q401 per cent.
  void drill_to(ig::Block& b, HoleRun& c, double level) const {
    const double depth = std::fabs(cycle_.get_or(b, 435, 0)), factor = cycle_.get_or(b, 401, 100);
    const double slow = c.surface - c.out() * depth;
    if (depth == 0 || !(factor > 0) || factor == 100) return cycle_.feed_to(b, c, level, c.feed);
    if ((c.level - slow) * c.out() > 0 && (slow - level) * c.out() > 0) cycle_.feed_to(b, c, slow, c.feed);
    cycle_.feed_to(b, c, level, (slow - level) * c.out() > 0 ? c.feed * factor / 100 : c.feed);
  }

  PeckStrokes strokes_of(const ig::Block& b, const HoleRun& c) const {
    const double from = std::fabs(cycle_.get_or(b, 379, 0));
    const double infeed = std::fabs(cycle_.get_or(b, 202, 0)), whole = std::fabs(c.bottom - c.surface) - from;
    HoleRun part = c;
    part.surface = c.surface - c.out() * from;
    if (!(whole > 0)) return {c.surface, c.bottom, std::fabs(c.bottom - c.surface)};
    if (!(infeed > 0 && infeed < whole)) return {part.surface, c.bottom, whole};
    return cycle_.shrinking_strokes(b, part, infeed);
  }
};

const ig::Register<KlartextSingleLipCycle> klartext_single_lip_cycle_syntax;

}  // namespace
}  // namespace heidenhain
