/// Which angle a rotary axis goes to: a position on the circle names all angles that differ by whole turns, and this
/// syntax picks one. In a compound motion it does so for each step, from where the step before it ended.
#include <isogloss/cnc/rotary_words.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct McAbcCyclicPath {
  static constexpr auto spec =
      ig::syntax("McAbcCyclicPathSyntax", "Rotary axes turn by the shortest way, or by the setting of the axis.")
          .after("McAbcSyntax")
          .before("CircularMotionSyntax", "LinearMotionSyntax");

  RotaryPosition rotary_{ig::read | ig::write | ig::wake};
  RotaryPosition before_{ig::previous};
  RotarySteps steps_;
  RotaryAxes axes_;
  ig::Signal by_words_{"McAbc.~Turns", ig::read};
  ig::Signal as_increment_{"McAbc.~AsIncrement", ig::read};
  RotaryIncrements increments_{ig::read};
  ig::In<ig::Symbol> term_{"RotaryPath.Term"};
  ig::Name difference_{"M127"};
  ig::Choice<HalfTurn> half_turn_{"half-turn", "positive|negative", "positive",
                                  "The direction of a rotation by exactly 180 degrees."};

  ig::Status build(ig::Block& b) {
    if (b.is_raised(as_increment_)) return ig::Status::unchanged;  // the program gives the distance itself
    const std::uint32_t fresh = rotary_.fresh(b);
    if (fresh == 0) return ig::Status::unchanged;
    const std::uint32_t steps = steps_.count(b);
    bool changed = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((fresh >> axis & 1u) == 0 || increments_.has(b, axis)) continue;
      const auto from = before_.get(b, axis), programmed = rotary_.get(b, axis);
      if (from && programmed) changed |= turn(b, axis, *from, *programmed, steps);
    }
    return changed ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  bool turn(ig::Block& b, std::size_t axis, double at, double programmed, std::uint32_t steps) const {
    bool changed = false;
    const std::uint32_t one = 1u << axis;
    for (std::uint32_t step = 0; step < steps; ++step) {
      PartialAngles to = steps_.get(b, step);
      if (!to.has(axis)) continue;
      const double wanted = to.value[axis];
      at = approach(b, axis, at, wanted);
      if (is_same(at, wanted)) continue;
      to.mask = one;
      to.value[axis] = at;
      steps_.set(b, step, to);
      changed = true;
    }
    const double end = approach(b, axis, at, programmed);
    if (is_same(end, programmed)) return changed;
    rotary_.set(b, axis, end);
    return true;
  }

  /// From 0 up to 360.
  static double within_turn(double angle) {
    const double rest = std::fmod(angle, 360);
    return rest < 0 ? rest + 360 : rest;
  }

  /// Bit for bit, so that A-0 is changed to 0.
  static bool is_same(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }

  /// The sign is a direction only in words of the program.
  double approach(const ig::Block& b, std::size_t axis, double from, double to) const {
    const bool is_signed = axes_.rollover(axis) == Rollover::signed_direction;
    if (is_signed && !b.is_raised(by_words_)) return nearest_turn(from, to, half_turn_);
    if (b.is(term_, difference_) && axes_.rollover(axis) == Rollover::shortest)
      return from + (within_turn(to) - within_turn(from));
    return axes_.approach(axis, from, to, half_turn_);
  }
};

const ig::Register<McAbcCyclicPath> mc_abc_cyclic_path_syntax;

}  // namespace
}  // namespace iso
