// Cycle 205, universal pecking: infeeds that become smaller, chip breaks inside each infeed, a full retract between
// them, and a return into the hole that stops at an advanced stop distance, different for each infeed.
#include "cycles/hole_cycle.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextPeckingCycle {
  static constexpr auto spec =
      hole_cycle("KlartextPeckingCycleSyntax", "Cycle 205, universal pecking, where it is called.");

  HoleCycle cycle_{{205, "CYCL205"}};

  ig::Status build(ig::Block& b) const { return cycle_.run(b, *this); }

  std::optional<double> prepare(ig::Block& b, HoleRun& c) const {
    if (!cycle_.drills(b, c)) return std::nullopt;
    if (!cycle_.get(b, 208)) c.retract = 0;
    for (const auto& [q, what] : {std::pair{379u, "Q379"}, std::pair{395u, "Q395"}})
      if (const double value = cycle_.get_or(b, q, 0); value != 0) {
        b.report(ig::diag("HEI-0178"), ig::Where::block(), 205.0, std::string_view(what), value);
        return std::nullopt;
      }
    const PeckStrokes strokes = strokes_of(b, c);
    const double by = std::fabs(cycle_.get_or(b, 257, 0)), whole = std::fabs(c.bottom - c.surface);
    return strokes.number() * 3 + (by > 0 ? 2 * (whole / by + strokes.number()) : 0) + 10;
  }

  void machine(ig::Block& b, HoleRun& c) const {
    const PeckStrokes strokes = strokes_of(b, c);
    const int count = static_cast<int>(strokes.number());
    const double first = std::fabs(cycle_.get_or(b, 258, 0)), last = std::fabs(cycle_.get_or(b, 259, first));
    double reached = c.surface;
    for (int k = 1; k <= count; ++k) {
      const double level = strokes.level(k, count);
      infeed(b, c, reached, level);
      reached = level;
      if (k == count) break;
      cycle_.rapid_to(b, c, c.safe);
      const double ahead = count > 2 ? first + (last - first) * (k - 1) / (count - 2) : first;
      cycle_.rapid_to(b, c, c.inside(strokes.above(level, ahead)));
    }
    cycle_.dwell(b, c.dwell);
    cycle_.feed_to(b, c, c.safe, c.retract);
    cycle_.leave(b, c);
  }

 private:
  PeckStrokes strokes_of(const ig::Block& b, const HoleRun& c) const {
    const double whole = std::fabs(c.bottom - c.surface), infeed = std::fabs(cycle_.get_or(b, 202, 0));
    if (!(infeed > 0 && infeed < whole)) return {c.surface, c.bottom, whole};
    return cycle_.shrinking_strokes(b, c, infeed);
  }

  /// One infeed, with a chip break after every Q257 of depth.
  void infeed(ig::Block& b, HoleRun& c, double from, double to) const {
    const double by = std::fabs(cycle_.get_or(b, 257, 0)), retract = std::fabs(cycle_.get_or(b, 256, 0));
    const PeckStrokes breaks(from, to, by > 0 ? by : std::fabs(to - from));
    const int count = static_cast<int>(breaks.number());
    for (int k = 1; k <= count; ++k) {
      const double level = breaks.level(k, count);
      cycle_.feed_to(b, c, level, c.feed);
      if (k < count) cycle_.rapid_to(b, c, c.inside(breaks.above(level, retract)));
    }
  }
};

const ig::Register<KlartextPeckingCycle> klartext_pecking_cycle_syntax;

}  // namespace
}  // namespace heidenhain
