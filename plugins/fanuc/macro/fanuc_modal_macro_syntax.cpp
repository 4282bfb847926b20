// After each block that moves the axes, the macro of the last G66 is called; G67 ends it. The syntax is asleep unless
// G66 is in force.
#include "macro/macro_environment.hpp"
#include "macro/macro_program_call.hpp"

namespace fanuc {
namespace {

struct FanucModalMacro {
  static constexpr auto spec =
      ig::syntax("FanucModalMacroSyntax", "Calls the macro of G66 after each block that moves; G67 ends it.")
          .after("LinearMotionSyntax", "CircularMotionSyntax", "ReferenceReturnSyntax", "FurtherAxesSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "FAN-0169", "this G67 ends nothing: no G66 is in force"),
  };

  MacroFrame frame_;
  ProgramsOfBuilder builder_;
  ig::Codes end_{"G67"};
  ig::Signal ended_{"Parsing.~ModalMacroEnded", ig::read};  // the G67 has ended a call of another kind
  ig::Signal modal_{"MacroCall.~Modal", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::In<ig::Symbol> move_{"MotionEvent.Form"}, steps_{"CompoundMotion.Term"};
  ig::Signal further_axes_moved_{"FurtherAxes.~Moved", ig::read};

  ig::Status build(ig::Block& b) {
    frame_.enter(b);
    MacroStore& store = frame_.store();
    std::vector<MacroStore::ModalCall>& calls = store.modal_calls();
    if (b.take(end_)) {
      if (b.is_raised(ended_)) return ig::Status::changed;
      if (calls.empty())
        b.report(ig::diag("FAN-0169"), ig::Where::word(end_.id(0)));
      else
        calls.pop_back();
      if (calls.empty() && store.depth() == 0) b.erase(modal_);
      return ig::Status::changed;
    }
    if (calls.empty() || calls.back().each_block || calls.back().repeats == 0 ||
        !(b.is_fresh(move_) || b.is_fresh(steps_) || b.is_raised(further_axes_moved_)))
      return ig::Status::unchanged;
    const MacroStore::ModalCall call = calls.back();
    report_deep_call(b, store, ig::Where::block());
    const std::uint64_t tag = store.enter(call.arguments, true);
    frame_.note_arguments(b, tag, call.arguments);
    settle_modal(store, ask_program(b, builder_, frame_.flow, call.program, call.repeats, tag, ig::Where::block(),
                                    call.arguments));
    return ig::Status::changed;
  }
};

const ig::Register<FanucModalMacro> fanuc_modal_macro_syntax;

}  // namespace
}  // namespace fanuc
