/// Requests the call of a program by its number or its name.
#pragma once

#include <isogloss/cnc/program_name.hpp>
#include <isogloss/flow.hpp>
#include <isogloss/sdk.hpp>

#include "macro/macro_store.hpp"

namespace fanuc {

using namespace ig::cnc;

/// Reports a macro call that is nested more deeply than the control permits.
inline void report_deep_call(ig::Block& b, const MacroStore& store, ig::Where where) {
  const std::uint32_t permitted = store.settings.call_nesting;
  if (store.depth() >= permitted)
    b.report(ig::diag("FAN-0168"), where, static_cast<double>(store.depth() + 1), static_cast<double>(permitted));
}

/// Requests the call. An answer other than done, which is reported, means that nothing is called.
inline ig::Flow::Answer ask_program(ig::Block& b, const ig::Flow& flow, const CalledProgram& program,
                                    std::int64_t repeats, std::uint64_t tag, ig::Where where) {
  const NumberedName number('O', program.number);
  const ProgramFileNames files(program.number);
  ig::Flow::Call call;
  call.program = number.text();
  call.files = files.list();
  ig_text file{};
  if (!program.name.empty()) {
    call.program = program.name;
    file = ig::to_text(call.program.substr(1, call.program.size() - 2));
    call.files = {&file, 1};
  }
  call.repeats = static_cast<std::uint32_t>(repeats);
  call.tag = tag;
  const ig::Flow::Answer answer = flow.call(b, call);
  if (answer.is_not_found())
    b.report(ig::diag("FAN-0165"), where, call.program, answer.reason);
  else if (answer.status == IG_GO_TAKEN)
    b.report(ig::diag("FAN-0170"), where, call.program);
  return answer;
}
inline bool call_program(ig::Block& b, const ig::Flow& flow, const CalledProgram& program, std::int64_t repeats,
                         std::uint64_t tag, ig::Where where) {
  return ask_program(b, flow, program, repeats, tag, where).is_done();
}

/// Call it after the macro of G66 or G66.1 was requested. A missing macro is reported once: later blocks do not call
/// it.
inline void settle_modal(MacroStore& store, const ig::Flow::Answer& answer) {
  if (answer.is_done()) return;
  store.leave_last();
  if (answer.is_not_found()) store.modal_calls().back().repeats = 0;
}

}  // namespace fanuc
