// Cycles 202, boring, and 204, back boring: the spindle stops at an angle, and the tool leaves the wall before it moves
// through the hole.
#include "cycles/hole_cycle.hpp"
#include "cycles/hole_spindle.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextBoringCycle {
  static constexpr auto spec =
      hole_cycle("KlartextBoringCycleSyntax", "Cycles 202 boring and 204 back boring where they are called.");

  HoleCycle cycle_{{202, "CYCL202"}, {204, "CYCL204"}};
  HoleSpindle spindle_;
  ig::NumberOption retraction_{"off-the-wall", "0.2", {0, 1000}, "mm", "How far cycle 202 moves off the wall."};

  ig::Status build(ig::Block& b) const { return cycle_.run(b, *this); }

  std::optional<double> prepare(ig::Block& b, HoleRun& c) const {
    const double direction = cycle_.get_or(b, 214, 0);
    const bool is_known =
        direction == std::floor(direction) && direction >= (c.number == 204 ? 1 : 0) && direction <= 4;
    if (!is_known) {
      b.report(ig::diag("HEI-0178"), ig::Where::block(), static_cast<double>(c.number), std::string_view("Q214"),
               direction);
      return std::nullopt;
    }
    if (c.number == 202) return cycle_.drills(b, c) ? std::optional(10.0) : std::nullopt;
    return prepare_back(b, c) ? std::optional(16.0) : std::nullopt;
  }

  void machine(ig::Block& b, HoleRun& c) const {
    const ig::Spindle start = spindle_.turns_ccw(b) ? ig::Spindle::ccw : ig::Spindle::cw;
    if (c.number == 202)
      bore(b, c, start);
    else
      bore_back(b, c, start);
  }

 private:
  /// Q249 is measured upwards from the underside, which lies Q250 below the surface. The tool length ends at the
  /// underside of the bar, Q252 below the cutting edge.
  bool prepare_back(ig::Block& b, HoleRun& c) const {
    const auto depth = cycle_.needed(b, c, 249), thickness = cycle_.needed(b, c, 250), edge = cycle_.needed(b, c, 252);
    if (!depth || !thickness || !edge || !cycle_.needed(b, c, 251)) return false;
    c.retract = cycle_.feed(b, c, 253);
    c.feed = cycle_.feed(b, c, 254);
    if (!(c.retract > 0 && c.feed > 0)) return false;
    if (*depth == 0) {
      b.report(ig::diag("HEI-0164"), ig::Where::block(), 204.0);
      return false;
    }
    if (!cycle_.levels(b, c, -std::fabs(*thickness) - std::fabs(*edge) - c.clearance)) return false;
    c.dwell = cycle_.get_or(b, 255, 0);
    return true;
  }

  /// The position of the hole, shifted by `distance` in the direction of Q214.
  ig::Vec3 aside(const ig::Block& b, const HoleRun& c, double distance) const {
    ig::Vec3 hole = c.hole;
    const int direction = static_cast<int>(cycle_.get_or(b, 214, 0));
    if (direction == 0) return hole;
    const std::size_t axis = direction % 2 == 1 ? c.plane.first : c.plane.second;
    hole[axis] = rounded(hole[axis] + (direction <= 2 ? -distance : distance));
    return hole;
  }

  void bore(ig::Block& b, HoleRun& c, ig::Spindle start) const {
    const ig::Vec3 centre = c.hole, off = aside(b, c, retraction_);
    cycle_.feed_to(b, c, c.bottom, c.feed);
    cycle_.dwell(b, c.dwell);
    cycle_.motion.orient(b, cycle_.get_or(b, 336, 0));
    c.hole = off;
    if (!(off == centre)) cycle_.motion.rapid_to(b, c.at(c.bottom));
    cycle_.feed_to(b, c, c.safe, c.retract);
    cycle_.leave(b, c);
    c.hole = centre;
    if (!(off == centre)) cycle_.motion.rapid_to(b, c.at(c.level));
    if (spindle_.turns(b)) cycle_.motion.spindle(b, start);
  }

  void bore_back(ig::Block& b, HoleRun& c, ig::Spindle start) const {
    const ig::Vec3 centre = c.hole, off = aside(b, c, std::fabs(cycle_.get_or(b, 251, 0)));
    const double angle = cycle_.get_or(b, 336, 0), below = c.bottom;
    const auto move_to = [&](const ig::Vec3& hole) {
      c.hole = hole;
      cycle_.feed_to(b, c, below, c.retract);
    };
    cycle_.motion.orient(b, angle);
    c.hole = off;
    cycle_.motion.rapid_to(b, c.at(c.safe));
    move_to(off);
    move_to(centre);
    cycle_.motion.spindle(b, start);
    cycle_.feed_to(b, c, below + c.clearance + cycle_.get_or(b, 249, 0), c.feed);
    cycle_.dwell(b, c.dwell);
    cycle_.feed_to(b, c, below, c.retract);
    cycle_.motion.orient(b, angle);
    move_to(off);
    cycle_.feed_to(b, c, c.safe, c.retract);
    cycle_.leave(b, c);
    c.hole = centre;
    cycle_.motion.rapid_to(b, c.at(c.level));
    if (spindle_.turns(b)) cycle_.motion.spindle(b, start);
  }
};

const ig::Register<KlartextBoringCycle> klartext_boring_cycle_syntax;

}  // namespace
}  // namespace heidenhain
