/// Reports an S above the speed that parameter Pr3741 allows. The speed stays as programmed.

#include <isogloss/sdk.hpp>

namespace syntec {
namespace {

struct SyntecSpindleLimit {
  static constexpr auto spec = ig::syntax("SyntecSpindleLimitSyntax", "Reports an S above the spindle's maximum speed.")
                                   .after("SpindleSpeedSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "SYN-0005",
                     "S{0} is above {1} rpm, the limit in Pr3741: check S; it stays as programmed"),
  };

  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm", ig::wake};
  ig::In<double> s_{"Parsing.S"};
  ig::Config motion_{"isogloss.motion/1", ig::Need::optional, "MaximumSpindleSpeed_rpm"};
  double limit_ = motion_.number("MaximumSpindleSpeed_rpm").value_or(0);

  SyntecSpindleLimit() {
    if (!(limit_ > 0)) ig::stay_idle();
  }

  ig::Status build(ig::Block& b) const {
    const double speed = b.get_or(speed_, 0.0);
    if (limit_ > 0 && b.is_fresh(speed_) && speed > limit_)
      b.report(ig::diag("SYN-0005"), ig::Where::word(s_.id()), speed, limit_);
    return ig::Status::unchanged;
  }
};

const ig::Register<SyntecSpindleLimit> syntec_spindle_limit_syntax;

}  // namespace
}  // namespace syntec
