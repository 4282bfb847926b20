/// G31: a straight feed move that ends at the skip signal. There is no signal here, so the move goes to its end point,
/// which is reported once. Fanuc manual, "Skip function".
#include <isogloss/cnc/motion_event.hpp>
#include <isogloss/cnc/program_xyz.hpp>

#include "motion/further_axis_order.hpp"

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
      ig::diagnostic(IG_WARNING, "ISO-0585", "G31 without an axis word: nothing moves"),
      ig::diagnostic(IG_ERROR, "ISO-0586", "G31 under radius compensation: program G40 first"),
  };

  ig::Call g31_{{"G31"}, "P[] Q[] R[]"};
  ig::Xyz machine_{"MachineCoordinate", ig::read};
  ig::Xyz program_{"ProgramXyz", ig::read};
  ig::Signal said_{"SkipFunction.~Said", ig::read | ig::write, ig::Life::modal};
  ig::In<ig::Symbol> side_{"RadiusCompensation.Side"};
  ig::Codes sides_{{"G40", "G41", "G42"}, ig::read};
  ig::Name left_{"Left"}, right_{"Right"};
  NamesFurtherAxes names_further_;
  BlockMotion motion_;
  LastProgramXyz last_;

  ig::Status build(ig::Block& b) {
    if (!b.take(g31_)) return ig::Status::unchanged;
    const ig::Where where = ig::Where::word(g31_.code(0));
    if (!b.is_fresh(machine_) && !names_further_(b)) {
      b.report(ig::diag("ISO-0585"), where);
      return ig::Status::changed;
    }
    if (is_compensated(b)) {
      b.report(ig::diag("ISO-0586"), where);
      b.alarm();
    }
    if (!b.is_raised(said_)) b.report(ig::diag("ISO-0390"), where);
    b.raise(said_);
    if (b.is_fresh(machine_) && !motion_.is_moving(b))
      motion_.feed(b, [&] { return length(b.get(program_).or_else({}) - last_(b)); });
    return ig::Status::changed;
  }

 private:
  bool is_compensated(const ig::Block& b) const {
    if (const auto code = b.find(sides_)) return *code != 0;
    return b.is(side_, left_) || b.is(side_, right_);
  }
};

const ig::Register<SkipFunction> skip_function_syntax;

}  // namespace
}  // namespace iso
