/// G31: a straight feed move that ends at the skip signal. There is no signal here, so the move goes to its end point,
/// which is reported once. Fanuc manual, "Skip function".
#include <isogloss/cnc/motion_event.hpp>
#include <isogloss/cnc/program_xyz.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct SkipFunction {
  static constexpr auto spec = ig::syntax("SkipFunctionSyntax", "G31 feed move up to the skip signal.")
                                   .after("FeedrateSyntax", "McXyzSyntax")
                                   .before("CircularMotionSyntax", "LinearMotionSyntax")
                                   .first_writer("Motion");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_NOTE, "ISO-0390", "G31: no skip signal is simulated, so the move goes to its end"),
  };

  ig::Call g31_{{"G31"}, "P[] Q[] R[]"};
  ig::Xyz machine_{"MachineCoordinate", ig::read};
  ig::Xyz program_{"ProgramXyz", ig::read};
  ig::Signal said_{"SkipFunction.~Said", ig::read | ig::write, ig::Life::modal};
  BlockMotion motion_;
  LastProgramXyz last_;

  ig::Status build(ig::Block& b) {
    if (!b.take(g31_)) return ig::Status::unchanged;
    if (!b.is_raised(said_)) b.report(ig::diag("ISO-0390"), ig::Where::word(g31_.code(0)));
    b.raise(said_);
    if (b.is_fresh(machine_) && !motion_.is_moving(b))
      motion_.feed(b, [&] { return length(b.get(program_).or_else({}) - last_(b)); });
    return ig::Status::changed;
  }
};

const ig::Register<SkipFunction> skip_function_syntax;

}  // namespace
}  // namespace iso
