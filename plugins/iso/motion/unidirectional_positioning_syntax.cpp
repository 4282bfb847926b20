/// G60: a rapid whose last part always comes from the same side, so that backlash has no effect. The axes overrun the
/// target by a distance that is set on the machine and come back to it. Fanuc manual, "Single direction positioning".
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/sdk.hpp>

#include "motion/further_axis_order.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct UnidirectionalPositioning {
  static constexpr auto spec =
      ig::syntax("UnidirectionalPositioningSyntax", "G60 positioning from one side.")
          .after("UnitModeSyntax", "CannedCycleResolveSyntax", "IncrementalResolveSyntax", "MachineCoordSelectSyntax")
          .before("ProgramXyzSyntax", "McXyzSyntax", "CircularMotionSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_NOTE, "ISO-0392", "G60: the overrun of the axes is not known, so a plain rapid is made"),
      ig::diagnostic(IG_WARNING, "ISO-0395", "G60 without an axis word: nothing moves"),
  };

  ig::Codes g60_{"G60"};
  ig::Xyz words_{"Parsing", ig::take};
  ig::Xyz program_{"ProgramXyz", ig::write};
  NamesFurtherAxes names_further_;
  ig::CompoundMotion motion_;
  LastProgramXyz last_;
  ig::Config config_{"isogloss.motion/1", ig::Need::optional, "UnidirectionalOverrunX_mm, …Y_mm, …Z_mm"};
  std::array<ig::NumberOption, 3> options_{option("overrun-x"), option("overrun-y"), option("overrun-z")};
  std::array<double, 3> overrun_{overrun(0, "UnidirectionalOverrunX_mm"), overrun(1, "UnidirectionalOverrunY_mm"),
                                 overrun(2, "UnidirectionalOverrunZ_mm")};

  ig::Status build(ig::Block& b) {
    const auto code = b.take(g60_);
    if (!code) return ig::Status::unchanged;
    const ig::PartialVec3 named = b.take(words_);
    if (named.mask == 0) {
      if (!names_further_(b)) b.report(ig::diag("ISO-0395"), ig::Where::word(g60_.id(0)));
      return ig::Status::changed;
    }
    const ig::Vec3 to = named.or_else(last_(b));
    ig::Vec3 over = to;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (named.has(axis)) over[axis] -= overrun_[axis];
    if (over == to) b.report(ig::diag("ISO-0392"), ig::Where::word(g60_.id(0)));
    motion_.begin(b, g60_.name(*code));
    if (over != to) motion_.rapid_to(b, over);
    motion_.rapid_to(b, to);
    b.set(program_, to);
    return ig::Status::changed;
  }

 private:
  static ig::NumberOption option(const char* name) {
    return {name,
            "0",
            {-1000, 1000},
            "mm",
            "Signed distance from the overrun point to the target; 0: the value of isogloss.motion/1."};
  }
  double overrun(std::size_t axis, std::string_view name) const {
    return options_[axis] != 0 ? double{options_[axis]} : config_.number(name).value_or(0);
  }
};

const ig::Register<UnidirectionalPositioning> unidirectional_positioning_syntax;

}  // namespace
}  // namespace iso
