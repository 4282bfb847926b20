/// S and M03, M04, M05: speed and direction of the spindle, both modal and independent: M05 keeps the speed, so that a
/// later M03 without S turns as before. G96 makes S a surface speed; the spindle speed that follows from it is not
/// known here.
#include <isogloss/cnc/modal_group.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct SpindleSpeed {
  static constexpr auto spec =
      ig::syntax("SpindleSpeedSyntax", "S, M03/M04/M05 and G96/G97: spindle speed and direction.")
          .before("CannedCycleResolveSyntax", "CircularMotionSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0212",
                     "S{0} is negative, so the previous spindle speed stays in force: use M04 to reverse"),
      ig::diagnostic(IG_WARNING, "ISO-0389",
                     "G96: the spindle speed in revolutions per minute is not known until G97 with S"),
      ig::diagnostic(IG_WARNING, "ISO-0396", "G97 without S after G96: the spindle speed is not known, so program S"),
  };

  ig::Word s_{"Parsing.S"};
  ig::Codes directions_{"M03", "M04", "M05"};
  ig::Codes modes_{"G96", "G97"};
  ig::Call surface_words_{{"G96"}, "S[]"};
  ig::Out<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::Out<ig::Symbol> direction_{"SpindleSpeed.Direction"};
  ig::Out<ig::Symbol> term_{"SpindleSpeed.Term"};
  ig::Out<double> surface_speed_{"SpindleSpeed.SurfaceSpeed"};
  ig::Name cw_{"CW"}, ccw_{"CCW"}, stop_{"STOP"};
  ig::Name g96_{"G96"};

  ig::Status build(ig::Block& b) {
    auto s = b.take(s_);
    ig_field place = s_.id();
    const auto mode = take_modal(b, modes_);
    if (mode) {
      if (const auto words = b.take(surface_words_); words && (*words)['S']) {
        s = (*words)['S'];
        place = surface_words_.word(0, 'S');
      }
      change_mode(b, *mode, s.has_value());
    }
    if (s && *s >= 0) b.set(b.is(term_, g96_) ? surface_speed_ : speed_, *s);
    if (s && *s < 0) b.report(ig::diag("ISO-0212"), ig::Where::word(place), *s);
    const auto direction = take_modal(b, directions_);
    if (direction) b.set(direction_, *direction == 0 ? cw_ : *direction == 1 ? ccw_ : stop_);
    return s || direction || mode ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// The spindle speed of the blocks before does not hold under G96, and after G96 none is known until an S.
  void change_mode(ig::Block& b, std::size_t mode, bool has_s) const {
    const bool was_surface = b.is(term_, g96_);
    if (mode == 0) {
      if (!was_surface) b.report(ig::diag("ISO-0389"), ig::Where::word(modes_.id(0)));
      b.erase(speed_);
      b.set(term_, modes_.name(0));
    } else if (was_surface) {
      if (!has_s) b.report(ig::diag("ISO-0396"), ig::Where::word(modes_.id(1)));
      b.erase(surface_speed_);
      b.erase(term_);
    }
  }
};

const ig::Register<SpindleSpeed> spindle_speed_syntax;

}  // namespace
}  // namespace iso
