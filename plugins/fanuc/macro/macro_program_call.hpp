/// Requests the call of a program by its number or its name.
#pragma once

#include <isogloss/cnc/machine_codes.hpp>
#include <isogloss/cnc/program_name.hpp>
#include <isogloss/flow.hpp>
#include <isogloss/sdk.hpp>

#include "macro/macro_arguments.hpp"
#include "macro/macro_store.hpp"

namespace fanuc {

using namespace ig::cnc;

/// Reports a macro call that is nested more deeply than the control permits.
inline void report_deep_call(ig::Block& b, const MacroStore& store, ig::Where where) {
  const std::uint32_t permitted = store.settings.call_nesting;
  if (store.depth() >= permitted)
    b.report(ig::diag("FAN-0168"), where, static_cast<double>(store.depth() + 1), static_cast<double>(permitted));
}

/// The request alone. The answer's reason is valid to the end of the block.
inline ig::Flow::Answer request_program(ig::Block& b, const ig::Flow& flow, const CalledProgram& program,
                                        std::int64_t repeats, std::uint64_t tag) {
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
  return flow.call(b, call);
}

/// The program of a row of MachineCodes: "9010", "O9010" or a name.
inline CalledProgram program_of_row(const ig_machine_code& row) {
  std::string_view written = ig::to_view(row.program);
  if (!written.empty() && to_upper(written[0]) == 'O' && is_digit(at(written, 1))) written.remove_prefix(1);
  const auto number = numbered_name('O', written);
  if (!number) return {0, "<" + std::string(ig::to_view(row.program)) + ">"};
  CalledProgram out{};
  std::from_chars(written.data(), written.data() + written.size(), out.number);
  return out;
}

/// What {A} is in a row of MachineCodes: the argument of G65 at this address.
inline std::optional<double> argument(const MacroStore::Locals& arguments, std::string_view name) {
  const std::uint32_t variable = name.size() == 1 && is_letter(name[0]) ? variable_of[letter_index(name[0])] : 0;
  const double value = arguments[variable];
  return variable == 0 || std::isnan(value) ? std::nullopt : std::optional(value);
}

/// Requests the call. MachineCodes may have a row in place of the program. An answer other than done, which is
/// reported, means that nothing is called.
inline ig::Flow::Answer ask_program(ig::Block& b, const ProgramsOfBuilder& builder, const ig::Flow& flow,
                                    const CalledProgram& program, std::int64_t repeats, std::uint64_t tag,
                                    ig::Where where, const MacroStore::Locals& arguments = MacroStore::no_locals()) {
  const NumberedName number('O', program.number);
  const std::string name = program.name.empty() ? std::string(number.text()) : program.name;
  const std::string bare = program.name.empty() ? name : name.substr(1, name.size() - 2);
  ig::Flow::Answer answer{IG_GO_NOT_FOUND, {}};
  const auto settle = [&](const CalledProgram& called, std::string_view shown) {
    answer = request_program(b, flow, called, repeats, tag);
    if (answer.status == IG_GO_TAKEN) b.report(ig::diag("FAN-0170"), where, shown);
    return !answer.is_not_found();
  };
  const auto execute = [&](const ig_machine_code& row) {
    answer = {IG_GO_REFUSED, {}};
    const auto call = [&](std::string_view other) {
      if (!settle(program_of_row(row), other)) b.report(ig::diag("FAN-0165"), where, other, answer.reason);
    };
    builder.execute(b, row, bare, where, call, [&](std::string_view word) { return argument(arguments, word); });
  };
  if (const ig_machine_code* const own = builder.row(bare))
    execute(*own);
  else if (settle(program, name))
    return answer;
  else if (const ig_machine_code* const family = builder.family(bare))
    execute(*family);
  else if (builder.ignores(b, name, where))
    answer = {IG_GO_REFUSED, {}};
  else
    b.report(ig::diag("FAN-0165"), where, name, answer.reason);
  return answer;
}
inline bool call_program(ig::Block& b, const ProgramsOfBuilder& builder, const ig::Flow& flow,
                         const CalledProgram& program, std::int64_t repeats, std::uint64_t tag, ig::Where where) {
  return ask_program(b, builder, flow, program, repeats, tag, where).is_done();
}

/// Call it after the macro of G66 or G66.1 was requested. A missing macro is reported once: later blocks do not call
/// it.
inline void settle_modal(MacroStore& store, const ig::Flow::Answer& answer) {
  if (answer.is_done()) return;
  store.leave_last();
  if (answer.is_not_found()) store.modal_calls().back().repeats = 0;
}

}  // namespace fanuc
