/// M19: the spindle stops at one fixed angle, so that a tool can be changed or a boring bar moved off the wall.

#include <isogloss/sdk.hpp>

namespace iso {
namespace {

struct SpindleOrientation {
  static constexpr auto spec = ig::syntax("SpindleOrientationSyntax", "M19 oriented spindle stop.")
                                   .after("ParameterizedFlagSyntax", "SpindleSpeedSyntax")
                                   .before("CannedCycleResolveSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0588",
                     "M19 stops the spindle, so the code of this block that turns it is not executed"),
  };

  enum class AngleWords { none, r, p, r_or_p };

  ig::Call m19_{{"M19"}, "R[deg] P[deg]"};
  ig::Out<double> angle_{"SpindleOrientation.Angle_deg"};
  ig::Field<ig::Symbol> direction_{"SpindleSpeed.Direction", ig::read | ig::write};
  ig::Name stop_{"STOP"};
  ig::NumberOption default_angle_{"angle", "0", {0, 360}, "deg", "Where the spindle stops without an angle word."};
  ig::Choice<AngleWords> angle_words_{"angle-words", "none|R|P|R-or-P", "R-or-P", "The words that give the angle."};

  ig::Status build(ig::Block& b) {
    if (b.take_code(m19_.codes(), m19_.code_count()) < 0) return ig::Status::unchanged;
    std::optional<double> angle;
    if (angle_words_ == AngleWords::p || angle_words_ == AngleWords::r_or_p) angle = take(b, 'P');
    if (angle_words_ == AngleWords::r || angle_words_ == AngleWords::r_or_p)
      if (const auto r = take(b, 'R')) angle = r;
    b.set(angle_, angle.value_or(default_angle_));
    if (b.is_fresh(direction_) && !b.is(direction_, stop_))
      b.report(ig::diag("ISO-0588"), ig::Where::word(m19_.code(0)));
    b.set(direction_, stop_);
    return ig::Status::changed;
  }

 private:
  std::optional<double> take(ig::Block& b, char letter) const {
    ig_value v;
    if (!b.take(m19_.word(0, letter), v)) return std::nullopt;
    return v.number;
  }
};

const ig::Register<SpindleOrientation> spindle_orientation_syntax;

}  // namespace
}  // namespace iso
