// Cycle 12, PGM CALL: a call of the cycle runs the program that its definition names, after the move of the block.
#include <isogloss/sdk.hpp>

#include "flow/called_program.hpp"
#include "language/klartext_values.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextProgramCycle {
  static constexpr auto spec =
      ig::syntax("KlartextProgramCycleSyntax", "Cycle 12, PGM CALL: calls the program that the definition names.")
          .after("KlartextCycleSyntax", "KlartextPathSyntax", "KlartextMotionSyntax")
          .before("KlartextCycleCheckSyntax", "RadiusCompensationSyntax");

  Values values_;
  ig::In<bool> call_{
      "KlartextCycle.IsCalled", ig::wake, {ig::Life::block, "", "The block calls the cycle: CYCL CALL, M99 or M89."}};
  ig::In<bool> modal_call_{
      "KlartextCycle.IsModal", ig::read, {ig::Life::modal, "", "M89: each positioning block calls the cycle."}};
  ig::In<std::int64_t> number_{
      "CycleDefinition.Number", ig::read, {ig::Life::modal, "", "The cycle that CYCL CALL runs."}};
  ig::In<ig::Symbol> program_{
      "CycleDefinition.Program", ig::read, {ig::Life::modal, "", "The program that cycle 12 calls."}};
  ig::Signal done_{"KlartextCycle.~Done", ig::read | ig::write};
  ig::Out<ig::Symbol> term_{"SubProgramCall.Term"};
  ig::TextField file_name_{"SubProgramCall.FileName", ig::write};
  ig::Name cycle_12_{"CYCL DEF 12"};
  ig::Signal ends_side_{"KlartextCycle.~EndsSide", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::In<ig::Symbol> side_{"RadiusCompensation.Term"};
  ig::Codes sides_{{"G40", "G41", "G42"}, ig::read | ig::write};

  ig::Status build(ig::Block& b) const {
    const bool any = end_side(b);
    const bool is_called = b.has(call_) && !b.has(modal_call_) && b.get_or(number_, std::int64_t{0}) == 12;
    if (!is_called || b.is_raised(done_)) return any ? ig::Status::changed : ig::Status::unchanged;
    b.raise(done_);
    const std::string_view path = b.text(b.get_or(program_, ig::Symbol{}));
    if (path.empty()) {
      b.report(ig::diag("HEI-0163"), ig::Where::block(), 12.0, std::string_view("the name of the program"));
      return ig::Status::changed;
    }
    b.set(term_, cycle_12_);
    b.set_text(file_name_, path);
    const ig::Flow::Answer answer = ask_program(b, values_.flow(), path);
    if (answer.is_not_found())
      b.report(ig::diag("HEI-0121"), ig::Where::block(), path, answer.reason);
    else if (is_beside(b))
      b.raise(ends_side_);
    return ig::Status::changed;
  }

 private:
  bool is_beside(const ig::Block& b) const { return b.is(side_, sides_.name(1)) || b.is(side_, sides_.name(2)); }

  /// A call of a program ends RL and RR, after the move of its block: in the first block of the program.
  bool end_side(ig::Block& b) const {
    if (!b.is_raised(ends_side_)) return false;
    b.erase(ends_side_);
    if (is_beside(b) && !b.find(sides_)) b.raise(sides_.id(0));
    return true;
  }
};

const ig::Register<KlartextProgramCycle> klartext_program_cycle_syntax;

}  // namespace
}  // namespace heidenhain
