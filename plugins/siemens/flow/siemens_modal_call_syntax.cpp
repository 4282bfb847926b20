/// MCALL NAME: the subprogram is called after each block that moves, up to MCALL alone.
#include "language/siemens_environment.hpp"

namespace siemens {
namespace {

struct SiemensModalCall {
  static constexpr auto spec = ig::syntax("SiemensModalCallSyntax", "MCALL of a subprogram, after each move.")
                                   .after("SiemensCallSyntax", "SiemensCycleSyntax", "LinearMotionSyntax");

  ig::Codes mcall_{{"MCALL"}, ig::read | ig::wake};
  ig::Signal begins_{"ModalCall.~Begins", ig::read};
  ig::Signal in_force_{"ModalCall.~InForce", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::In<ig::Symbol> steps_{"CompoundMotion.Term"};
  ig::Out<ig::Symbol> term_{"SubProgramCall.Term"};
  Environment environment_;

  ig::Status build(ig::Block& b) {
    if (b.find(mcall_)) {
      if (b.is_raised(begins_))
        b.raise(in_force_);
      else
        b.erase(in_force_);
      return ig::Status::changed;
    }
    const ModalCall& modal = environment_.store().modal;
    const bool moves = b.has(form_) || b.has(steps_);
    if (!b.is_raised(in_force_) || !moves || environment_.flow.frame(b).id != modal.frame) return ig::Status::unchanged;
    call(b, modal);
    return ig::Status::changed;
  }

 private:
  void call(ig::Block& b, const ModalCall& modal) const {
    const CalledFiles files(modal.program, environment_.store().call_path);
    ig::Flow::Call call;
    call.program = modal.program.name;
    call.files = files.list();
    call.tag = environment_.store().pass(modal.arguments);
    const ig_place here = environment_.flow.here(b);
    if (auto& patterns = environment_.store().patterns;
        !patterns.empty() && patterns.back().is_at(here.frame, here.offset))
      patterns.back().tag = call.tag;
    b.set(term_, b.symbol(modal.program.name));
    const ig::Flow::Answer answer = environment_.flow.call(b, call);
    if (answer.is_not_found())
      environment_.report_once(b, ig::diag("SIE-0165"), ig::Where::block(), 0, std::string_view(modal.program.name),
                               answer.reason);
    else if (answer.status == IG_GO_TAKEN)
      b.report(ig::diag("SIE-0167"), ig::Where::block(), std::string_view(modal.program.name));
  }
};

const ig::Register<SiemensModalCall> siemens_modal_call_syntax;

}  // namespace
}  // namespace siemens
