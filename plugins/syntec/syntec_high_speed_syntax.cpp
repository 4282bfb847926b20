/// E of G05 P10000 and G05.1: the tolerance of high-speed, high-precision control. It rounds corners and changes no
/// programmed point, so it is recorded like the data of PathSmoothingSyntax. G120.1 and G121 select one of its
/// parameter sets and move no axis either.

#include <isogloss/sdk.hpp>

namespace syntec {
namespace {

struct SyntecHighSpeed {
  static constexpr auto spec = ig::syntax("SyntecHighSpeedSyntax", "Records E of G05 and G05.1, the path tolerance.")
                                   .after("ParameterizedFlagSyntax", "UnitModeSyntax", "PathSmoothingSyntax")
                                   .before("IsoCoordinateOffsetSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "SYN-0006",
                     "{0}: E{1} is not a tolerance greater than 0: the tolerance in force stays"),
  };

  ig::Call codes_{{"G05", "G05.1"}, "E[mm]"};
  ig::Call sets_{{"G120.1"}, "P[] Q[]"};
  ig::Codes end_of_set_{"G121"};
  ig::Field<double> tolerance_{"PathSmoothing.Tolerance_mm",
                               ig::read | ig::write,
                               {ig::Life::modal, "mm", "How far the path may round a corner."}};

  ig::Status build(ig::Block& b) const {
    bool any = b.take(sets_).has_value();
    any |= b.take(end_of_set_).has_value();
    for (std::uint32_t row = 0; row < codes_.code_count(); ++row) {
      ig_value e;
      if (!b.take(codes_.word(row, 'E'), e)) continue;
      any = true;
      if (e.number > 0)
        b.set(tolerance_, e.number);
      else
        b.report(ig::diag("SYN-0006"), ig::Where::word(codes_.word(row, 'E')), b.text(codes_.name(row)), e.number);
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }
};

const ig::Register<SyntecHighSpeed> syntec_high_speed_syntax;

}  // namespace
}  // namespace syntec
