// CYCL DEF of cycles that the builder of the machine has added, as the table MachineCodes says, and the programs that its
// cycles and M functions call. Such a cycle acts where it is defined; the cycle that waits for a call stays.
#include <isogloss/cnc/machine_codes.hpp>

#include "cycles/cycle_text.hpp"
#include "flow/called_program.hpp"
#include "language/block_words.hpp"
#include "motion/m_functions.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextMachineCode {
  static constexpr auto spec =
      ig::syntax("KlartextMachineCodeSyntax", "Cycles of the machine's builder, as MachineCodes says.")
          .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
          .before("KlartextCycleSyntax", "KlartextFrameCycleSyntax")
          .scans("Cc");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0340",
                     "the program {1} that {0} calls is not found, so it is not called: {2}"),
      ig::diagnostic(IG_ERROR, "HEI-0341",
                     "{0} does not call {1}, because the block already calls or jumps: use separate blocks"),
  };

  MachineCodes machine_;
  MachineCodeRecord record_;
  RecordedMachineCodes recorded_;
  CycleText text_{CycleText::Feeds::none};
  MFunctions m_;
  ig::Signal is_open_{"CycleDefinition.~Open", ig::read | ig::write, ig::Life::modal};
  ig::Out<ig::Symbol> term_{"SubProgramCall.Term"};
  ig::TextField file_name_{"SubProgramCall.FileName", ig::write};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (!machine_.holds_any() || !stands_first(text, position)) return position;
    const std::size_t definition = keyword(text, position, "CYCL DEF");
    const auto number = definition == position ? std::nullopt : CycleNumber::at(text, skip(text, definition));
    if (!number) return position;
    const ig_machine_code* const row = machine_.find("CYCL DEF " + std::to_string(number->cycle));
    if (row == nullptr) return position;
    const std::size_t end = statement_end(text, position);
    if (text_.values().is_indexing()) return end;
    if (b.is_raised(is_open_)) b.erase(is_open_);
    text = text.substr(0, end);
    text_.parameters(b, text, number->end, number->cycle, [](std::uint32_t, double) {});
    if (number->is_first()) answer(b, *row, text, position);
    return end;
  }

  ig::Status build(ig::Block& b) const {
    const ig_machine_code* const row = recorded_.find(b, IG_CODE_CALLS);
    if (row == nullptr) return ig::Status::unchanged;
    const std::string_view code = ig::to_view(row->name), program = ig::to_view(row->program);
    b.set(term_, b.symbol(code));
    b.set_text(file_name_, program);
    const ig::Flow::Answer answer = ask_program(b, text_.values().flow(), program);
    if (answer.is_not_found())
      b.report(ig::diag("HEI-0340"), ig::Where::block(), code, program, answer.reason);
    else if (answer.status == IG_GO_TAKEN)
      b.report(ig::diag("HEI-0341"), ig::Where::block(), code, program);
    return ig::Status::changed;
  }

 private:
  void answer(ig::Block& b, const ig_machine_code& row, std::string_view text, std::size_t position) const {
    const ig::Where where = where_of_line(text, position);
    record_.add(b, row, where);
    for_each_code(row, [&](std::string_view code) { m_.put(b, text_.values(), text, code, where.begin, where.end); });
  }
};

const ig::Register<KlartextMachineCode> klartext_machine_code_syntax;

}  // namespace
}  // namespace heidenhain
