/// G4: dwell. F is a time in seconds, S a number of spindle turns; neither changes the feed or the speed of later
/// blocks.

#include <isogloss/sdk.hpp>

namespace siemens {
namespace {

struct SiemensDwell {
  static constexpr auto spec = ig::syntax("SiemensDwellSyntax", "G4 dwell: F seconds, S turns of the spindle.")
                                   .after("ParameterizedFlagSyntax")
                                   .before("FeedrateSyntax", "SpindleSpeedSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0201",
                     "G4 has neither F nor S, so the block does not wait: program the seconds or the turns"),
      ig::diagnostic(IG_ERROR, "SIE-0202",
                     "G4 has a negative time, so the block does not wait: program F or S of 0 or more"),
      ig::diagnostic(IG_WARNING, "SIE-0204", "G4 has F and S: F is used, and S is ignored; remove one of them"),
      ig::diagnostic(
          IG_ERROR, "SIE-0203",
          "G4 S needs the spindle speed, which is not known, so the dwell takes no time: program S before it"),
  };

  ig::Call g04_{{"G04"}, "F[s] S[]"};
  ig::Out<double> time_{"Dwell.Time"};
  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};

  ig::Status build(ig::Block& b) {
    const auto words = b.take(g04_);
    if (!words) return ig::Status::unchanged;
    const auto where = ig::Where::word(g04_.code(0));
    const auto seconds = (*words)['F'], turns = (*words)['S'];
    const double rpm = b.get_or(speed_, 0.0);
    if (!seconds && !turns) {
      b.report(ig::diag("SIE-0201"), where);
    } else if (seconds.value_or(0) < 0 || turns.value_or(0) < 0) {
      b.report(ig::diag("SIE-0202"), where);
    } else if (seconds) {
      if (turns) b.report(ig::diag("SIE-0204"), where);
      b.set(time_, *seconds);
    } else if (rpm > 0) {
      b.set(time_, *turns * 60 / rpm);
    } else {
      b.report(ig::diag("SIE-0203"), where);
    }
    return ig::Status::changed;
  }
};

const ig::Register<SiemensDwell> siemens_dwell_syntax;

}  // namespace
}  // namespace siemens
