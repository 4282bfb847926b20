/// MCALL NAME: the subprogram is called after each block that moves, up to MCALL alone.
#include <isogloss/cnc/machine_codes.hpp>

#include "language/siemens_environment.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensModalCall {
  static constexpr auto spec = ig::syntax("SiemensModalCallSyntax", "MCALL of a subprogram, after each move.")
                                   .after("SiemensCallSyntax", "SiemensCycleSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0371",
                     "the row {0} of MachineCodes is not executed at each move of MCALL {1}: write a row of its name"),
  };

  ig::Codes mcall_{{"MCALL"}, ig::read | ig::wake};
  ig::Signal begins_{"ModalCall.~Begins", ig::read};
  ig::Signal in_force_{"ModalCall.~InForce", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::In<ig::Symbol> steps_{"CompoundMotion.Term"};
  ig::Out<ig::Symbol> term_{"SubProgramCall.Term"};
  Environment environment_;
  MachineCodes machine_;
  MachineCodeRecord record_;

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
  /// What MachineCodes does in place of a program that is not found: nothing, or an error, because a row acts only once.
  bool is_of_builder(ig::Block& b, const std::string& name) const {
    const ig_machine_code* const row = machine_.family(name);
    if (row == nullptr) {
      if (machine_.ignores_unknown_programs())
        environment_.report_once(b, ig::diag("ISO-0573"), ig::Where::block(), 0, std::string_view(name));
      return machine_.ignores_unknown_programs();
    }
    if (row->does == IG_CODE_DOES_NOTHING || row->does == IG_CODE_IS_REFUSED)
      record_.add(b, *row, ig::Where::block(), name);
    else
      environment_.report_once(b, ig::diag("SIE-0371"), ig::Where::block(), 0, ig::to_view(row->name),
                               std::string_view(name));
    return true;
  }

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
    if (answer.is_not_found() && is_of_builder(b, modal.program.name)) return;
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
