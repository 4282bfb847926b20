/// SPOS=90 and SPOSA=90: the spindle stops at an angle. M70: it stops and becomes an axis.
#include <cmath>

#include <isogloss/sdk.hpp>

#include "modes/axis_modes.hpp"

namespace siemens {
namespace {

struct SiemensSpindlePosition {
  static constexpr auto spec =
      ig::syntax("SiemensSpindlePositionSyntax", "SPOS= and SPOSA= oriented spindle stop.").after("SpindleSpeedSyntax");

  std::array<ig::Word, 2> words_{ig::Word{"Parsing.SPOS", ig::wake, "deg"}, ig::Word{"Parsing.SPOSA", ig::wake, "deg"}};
  ig::Codes m70_{"M70"};
  ig::Out<double> angle_{"SpindleOrientation.Angle_deg"};
  ig::Out<ig::Symbol> direction_{"SpindleSpeed.Direction"};
  ig::Name stop_{"STOP"};

  ig::Status build(ig::Block& b) {
    for (const ig::Word& word : words_)
      if (const auto angle = b.take(word)) {
        const double turn = std::fmod(*angle, 360);
        b.set(angle_, turn < 0 ? turn + 360 : turn);
        b.set(direction_, stop_);
        b.take(m70_);
        return ig::Status::changed;
      }
    if (!b.take(m70_)) return ig::Status::unchanged;
    b.set(direction_, stop_);
    return ig::Status::changed;
  }
};

const ig::Register<SiemensSpindlePosition> siemens_spindle_position_syntax;

}  // namespace
}  // namespace siemens
