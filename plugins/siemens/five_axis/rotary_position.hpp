/// The angle that C=DC(90), C=ACP(90), C=ACN(90) and C=IC(10) give to an axis whose present angle is `present`.
#pragma once

#include <cmath>

#include <isogloss/sdk.hpp>

namespace siemens {

struct RotaryModes {
  ig::Name ac{"AC"}, ic{"IC"}, dc{"DC"}, acp{"ACP"}, acn{"ACN"};

  double position(ig::Block& b, ig::Where where, double value, ig::Symbol mode, double present) const {
    if (mode == ic) return present + value;
    if (mode == ac) return value;
    if (value < 0 || value >= 360) b.report(ig::diag("SIE-0214"), where, b.text(mode), value);
    double turn = std::fmod(value - present, 360);
    if (turn < 0) turn += 360;
    if (mode == acn && turn > 0) turn -= 360;
    if (mode == dc && turn > 180) turn -= 360;
    return present + turn;
  }
};

}  // namespace siemens
