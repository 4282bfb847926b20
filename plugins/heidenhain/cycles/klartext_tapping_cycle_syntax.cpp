// Cycles 206, tapping with a floating chuck, 207, rigid tapping, and 209, tapping with chip breaking: the spindle
// reverses at the bottom, and the tool leaves the hole by feed.
#include "cycles/hole_cycle.hpp"
#include "cycles/hole_spindle.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

enum class After { stop, as_before };

struct KlartextTappingCycle {
  static constexpr auto spec =
      hole_cycle("KlartextTappingCycleSyntax", "Cycles 206, 207 and 209, tapping, where they are called.");

  HoleCycle cycle_{{206, "CYCL206"}, {207, "CYCL207"}, {209, "CYCL209"}};
  HoleSpindle spindle_;
  ig::Choice<After> after_{"spindle-after", "stop|as-before", "stop",
                           "What the spindle does after 207 and 209: it stops, or turns again as before."};

  ig::Status build(ig::Block& b) { return cycle_.run(b, *this); }

  std::optional<double> prepare(ig::Block& b, HoleRun& c) const {
    const auto depth = cycle_.needed(b, c, 201);
    if (!depth || !cycle_.levels(b, c, *depth)) return std::nullopt;
    if (c.number == 206) return cycle_.feeds(b, c) ? std::optional(8.0) : std::nullopt;
    const auto pitch = cycle_.needed(b, c, 239);
    if (!pitch) return std::nullopt;
    c.feed = cycle_.speed(b) * std::fabs(*pitch) / 60;
    const double factor = cycle_.get_or(b, 403, 0);
    c.retract = factor > 0 ? c.feed * factor : c.feed;
    if (!(c.feed > 0)) {
      b.report(ig::diag("HEI-0166"), ig::Where::block(), static_cast<double>(c.number),
               std::string_view(*pitch == 0 ? "Q239" : "the speed S"), *pitch == 0 ? *pitch : cycle_.speed(b));
      return std::nullopt;
    }
    return breaks_of(b, c).number() * 4 + 10;
  }

  void begin(ig::Block& b, const HoleRun& c) {
    before_ = spindle_.turns_ccw(b) ? ig::Spindle::ccw : spindle_.turns(b) ? ig::Spindle::cw : ig::Spindle::stop;
    last_ = c.number == 206         ? (before_ == ig::Spindle::ccw ? ig::Spindle::ccw : ig::Spindle::cw)
            : after_ == After::stop ? ig::Spindle::stop
                                    : before_;
    spindle_.leave(b, cycle_.motion, last_);
  }

  void machine(ig::Block& b, HoleRun& c) const {
    if (c.number == 206)
      tap_floating(b, c);
    else
      tap_rigidly(b, c);
  }

 private:
  ig::Spindle before_ = ig::Spindle::stop, last_ = ig::Spindle::stop;  // of the block

  PeckStrokes breaks_of(const ig::Block& b, const HoleRun& c) const {
    const double whole = std::fabs(c.bottom - c.surface);
    const double by = c.number == 209 ? std::fabs(cycle_.get_or(b, 257, 0)) : 0;
    return {c.surface, c.bottom, by > 0 && by < whole ? by : whole};
  }

  void tap_floating(ig::Block& b, HoleRun& c) const {
    const ig::Spindle in = last_;
    cycle_.motion.spindle(b, in);
    cycle_.feed_to(b, c, c.bottom, c.feed);
    cycle_.dwell(b, c.dwell);
    cycle_.motion.spindle(b, HoleSpindle::other(in));
    cycle_.feed_to(b, c, c.safe, c.feed);
    cycle_.motion.spindle(b, in);
    cycle_.leave(b, c);
  }

  void tap_rigidly(ig::Block& b, HoleRun& c) const {
    const double pitch = cycle_.get_or(b, 239, 0);
    const ig::Spindle in = pitch < 0 ? ig::Spindle::ccw : ig::Spindle::cw, out = HoleSpindle::other(in);
    const PeckStrokes strokes = breaks_of(b, c);
    const int count = static_cast<int>(strokes.number());
    const double back = std::fabs(cycle_.get_or(b, 256, 0) * pitch);
    if (c.number == 209) cycle_.motion.orient(b, cycle_.get_or(b, 336, 0));
    cycle_.motion.spindle(b, in);
    for (int k = 1; k <= count; ++k) {
      const double level = strokes.level(k, count);
      cycle_.feed_to(b, c, level, c.feed);
      cycle_.motion.spindle(b, out);
      if (k == count) break;
      cycle_.feed_to(b, c, back > 0 ? c.inside(strokes.above(level, back)) : c.safe, c.feed);
      cycle_.motion.spindle(b, in);
    }
    cycle_.feed_to(b, c, c.safe, c.retract);
    cycle_.motion.spindle(b, last_);
    cycle_.leave(b, c);
  }
};

const ig::Register<KlartextTappingCycle> klartext_tapping_cycle_syntax;

}  // namespace
}  // namespace heidenhain
