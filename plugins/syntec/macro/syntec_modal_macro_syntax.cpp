/// After each block that moves the axes, the macro of the last G66 is called; after each block of words that of G66.1;
/// G67 ends it. Its local variables live from G66 to G67. The syntax is asleep unless one of the three has come.
#include "macro/macro_requests.hpp"

namespace syntec {

using namespace ig::cnc;

namespace {

struct SyntecModalMacro {
  static constexpr auto spec =
      ig::syntax("SyntecModalMacroSyntax", "Calls the macro of G66 after blocks in MACRO format; G67 ends it.")
          .after("LinearMotionSyntax", "CircularMotionSyntax", "ReferenceReturnSyntax", "FurtherAxesSyntax",
                 "SyntecMacroCallSyntax")
          .before("FanucModalMacroSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "SYN-0075", "this G67 ends nothing: no G66 is in force"),
  };

  ig::Signal end_{"Parsing.~SyntecModalEnd", ig::read | ig::wake}, iso_end_{"Parsing.~ModalMacroEnded", ig::write};
  ig::Codes iso_code_{{"G67"}, ig::read | ig::wake};
  ig::Signal modal_{"SyntecMacro.~Modal", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::Signal words_{"Parsing.~MacroWords", ig::read};
  ig::Signal call_{"Parsing.~SyntecMacroCall", ig::read};
  ig::Codes returns_{{"M99"}, ig::read};
  ig::In<ig::Symbol> move_{"MotionEvent.Form"}, steps_{"CompoundMotion.Term"};
  ig::Signal further_axes_moved_{"FurtherAxes.~Moved", ig::read};
  FormatField format_{ig::read};
  ig::In<std::int64_t> skipped_layer_{"BlockSkip.Layer"};
  SharedScan scan_;
  MacroEnvironment environment_;

  ig::Status build(ig::Block& b) {
    environment_.enter(b);
    MacroStore& store = environment_.store();
    std::vector<ModalCall>& calls = store.level().modal;
    // The code is that of files in ISO format, and ends a G66 of such a file where there is none of the other format.
    const bool is_iso_end = b.find(iso_code_).has_value();
    if (is_iso_end && calls.empty()) {
      store.end_offer();
      return ig::Status::changed;
    }
    if (is_iso_end) b.raise(iso_end_);
    if (is_iso_end || b.is_raised(end_)) {
      if (calls.empty()) {
        b.report(ig::diag("SYN-0075"), ig::Where::block());
        return ig::Status::changed;
      }
      store.drop_modal(calls.back().tag);
      calls.pop_back();
      if (calls.empty() && environment_.flow.frame(b).depth == 0) b.erase(modal_);
      return ig::Status::changed;
    }
    if (calls.empty() || b.is_raised(call_) || b.find(returns_)) return ig::Status::unchanged;
    const ModalCall call = calls.back();
    const bool moves = b.is_fresh(move_) || b.is_fresh(steps_) || b.is_raised(further_axes_moved_);
    if (!moves && !(call.each_block && b.is_raised(words_))) return ig::Status::unchanged;
    const std::string_view text = b.source();
    store.set_trap(call.tag, format_.is_macro(b) ? scan_->arguments
                                                 : iso_arguments(text, skip_head(text, 0, text.size()),
                                                                 b.get_or(skipped_layer_, std::int64_t{0})));
    store.forget_frame();
    const ig::Flow::Answer answer =
        request_call(b, environment_.flow, call.number, call.program, call.repeats, call.tag);
    if (answer.is_done()) return ig::Status::changed;
    const NumberedName shown('O', call.number);
    const std::string_view name = call.number > 0 ? shown.text() : std::string_view(call.program);
    if (answer.is_not_found())
      b.report(ig::diag("SYN-0072"), ig::Where::block(), name, answer.reason);
    else if (answer.status == IG_GO_TAKEN)
      b.report(ig::diag("SYN-0076"), ig::Where::block(), name);
    return ig::Status::changed;
  }
};

const ig::Register<SyntecModalMacro> syntec_modal_macro_syntax;

}  // namespace
}  // namespace syntec
