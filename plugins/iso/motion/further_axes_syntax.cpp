// Axes beside X Y Z A B C that the machine's table declares: U, Q1, a second C2, the spindle as an axis SP1. Their
// words move them to positions of the machine. No motion carries them, but the document does, so nothing is lost
// silently.
#include <cmath>

#include <isogloss/cnc/further_axes.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/units.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct FurtherAxes {
  static constexpr auto spec = ig::syntax("FurtherAxesSyntax", "Positions of axes beside X Y Z A B C.")
                                   .after("UnitModeSyntax", "PositioningModeSyntax")
                                   .before("TravelCheckSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(
          IG_NOTE, "ISO-0577",
          "{0} moves in FurtherAxes of the block document alone: motions carry X Y Z A B C and no other axis"),
      ig::diagnostic(IG_ERROR, "ISO-0578", "{0} would go to {1}, beyond the end of its travel at {2}"),
      ig::diagnostic(IG_ERROR, "ISO-0579",
                     "the position of {0} would be no number, so {0} does not move: check the value"),
  };

  FurtherAxisWords words_{ig::take | ig::wake, ig::read};
  FurtherAxisPositions positions_{ig::read | ig::write};
  ig::Signal told_{"FurtherAxes.~Told", ig::read | ig::write, ig::Life::modal};
  ig::In<ig::Symbol> system_{"Unit.System"};
  DistanceMode distance_;
  AxisNames axes_;
  ig::Name inch_{"Inch"}, ac_{"AC"}, ic_{"IC"}, dc_{"DC"}, acn_{"ACN"};

  ig::Status restart(ig::Block& b) const {
    bool any = false;
    for (std::uint32_t axis = first_further_axis; is_further_axis(axis) && !axes_.name(axis).empty(); ++axis) {
      b.set(positions_.name(axis), b.symbol(axes_.name(axis)));
      b.set(positions_.position(axis), axes_.position(axis, IG_AXIS_HOME).value_or(0));
      any = true;
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) const {
    bool any = false;
    for (std::uint32_t axis = first_further_axis; is_further_axis(axis); ++axis) {
      ig_value word;
      const ig_field field = words_.word(axis).id();
      if (b.take_many(&field, 1, &word) == 0) continue;
      go(b, axis, word.number);
      any = true;
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  void go(ig::Block& b, std::uint32_t axis, double value) const {
    const std::string_view name = axes_.name(axis);
    const auto where = ig::Where::word(words_.word(axis).id());
    const bool is_rotary = axes_.is_rotary(axis);
    const double word = !is_rotary && b.is(system_, inch_) ? value * mm_per_inch : value;
    const double from = b.get_or(positions_.position(axis), 0.0);
    const double to = target(b, from, word, b.get_or(words_.mode(axis), ig::Symbol{}));
    if (!std::isfinite(to)) return b.report(ig::diag("ISO-0579"), where, name);
    b.set(positions_.name(axis), b.symbol(name));
    b.set(positions_.position(axis), to);
    const auto travel = axes_.travel(axis);
    if (travel && (to < travel->minimum || to > travel->maximum))
      b.report(ig::diag("ISO-0578"), where, name, to, to > travel->maximum ? travel->maximum : travel->minimum);
    if (b.is_raised(told_)) return;
    b.report(ig::diag("ISO-0577"), where, name);
    b.raise(told_);
  }

  double target(const ig::Block& b, double from, double word, ig::Symbol mode) const {
    if (mode == ic_ || (mode == ig::Symbol{} && distance_.is_incremental(b))) return from + word;
    if (mode == ig::Symbol{} || mode == ac_) return word;
    double turn = std::fmod(word - from, 360);
    if (turn < 0) turn += 360;
    if (mode == acn_ && turn > 0) turn -= 360;
    if (mode == dc_ && turn > 180) turn -= 360;
    return from + turn;
  }
};

const ig::Register<FurtherAxes> further_axes_syntax;

}  // namespace
}  // namespace iso
