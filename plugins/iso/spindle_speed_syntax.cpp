/// S and M03/M04/M05: speed and direction of the spindle, both modal and each on its own: M05 keeps the speed, so that
/// a later M03 without S runs as before.
#include "modal_group.hpp"

namespace iso {
namespace {

struct SpindleSpeed {
  static constexpr auto spec = ig::syntax("SpindleSpeedSyntax", "S and M03/M04/M05 spindle speed and direction.")
                                   .before("CannedCycleResolveSyntax", "CircularMotionSyntax", "LinearMotionSyntax");

  ig::Word s_{"Parsing.S"};
  ig::Codes directions_{"M03", "M04", "M05"};
  ig::Out<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::Out<ig::Symbol> direction_{"SpindleSpeed.Direction"};
  ig::Name cw_{"CW"}, ccw_{"CCW"}, stop_{"STOP"};

  ig::Status build(ig::Block& b) {
    const auto s = b.take(s_);
    if (s && *s >= 0) b.set(speed_, *s);
    if (s && *s < 0) b.report(diag("ISO-0212"), ig::Where::word(s_.id()), *s);
    const auto direction = take_modal(b, directions_);
    if (direction) b.set(direction_, *direction == 0 ? cw_ : *direction == 1 ? ccw_ : stop_);
    return s || direction ? ig::Status::changed : ig::Status::unchanged;
  }
};

const ig::Register<SpindleSpeed> registered;

}  // namespace
}  // namespace iso
