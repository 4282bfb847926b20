// CYCL DEF of cycles that the builder of the machine has added, as the table MachineCodes says, and the programs that
// its cycles and M functions call. A cycle acts where it is defined, and the cycle that waits for a call stays; or it
// waits for a call itself.
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
          .before("KlartextCycleSyntax", "KlartextFrameCycleSyntax", "KlartextParameterSyntax")
          .scans("CFTcft")
          .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0340", "the program {1} that {0} calls is not found, so it is not called: {2}"),
      ig::diagnostic(IG_ERROR, "HEI-0341",
                     "{0} does not call {1}, because the block already calls or jumps: use separate blocks"),
      ig::diagnostic(IG_ERROR, "HEI-0342",
                     "{0} is not executed at the holes of the pattern: its row in MachineCodes acts once"),
  };

  MachineCodes machine_;
  MachineCodeRecord record_;
  RecordedMachineCodes recorded_;
  CycleText text_{CycleText::Feeds::none};
  MFunctions m_;
  CycleDefinition definition_{ig::read | ig::write};
  ig::Field<std::int64_t> number_{"CycleDefinition.Number", ig::read | ig::write, {ig::Life::modal, "", ""}};
  ig::Signal said_{"CycleDefinition.~Said", ig::write, ig::Life::modal};
  ig::Field<bool> call_{"KlartextCycle.IsCalled", ig::read | ig::write | ig::wake, {ig::Life::block, "", ""}};
  ig::InWhile<bool> modal_call_{"KlartextCycle.IsModal", nullptr, ig::write};
  ig::Signal done_{"KlartextCycle.~Done", ig::write};
  ig::In<std::int64_t> pattern_{"KlartextPattern.Number", ig::read, {ig::Life::block, "", ""}};
  ig::Xyz words_{"Parsing", ig::read};
  ig::Signal is_open_{"CycleDefinition.~Open", ig::read | ig::write, ig::Life::modal};
  ig::Out<ig::Symbol> term_{"SubProgramCall.Term"};
  ig::TextField file_name_{"SubProgramCall.FileName", ig::write};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (!machine_.holds_any() || !stands_first(text, position) || !b.is_in_turn()) return position;
    if (to_upper(text[position]) == 'F') return function(b, text, position);
    if (to_upper(text[position]) == 'T') return probing(b, text, position);
    const std::size_t definition = keyword(text, position, "CYCL DEF");
    const auto number = definition == position ? std::nullopt : CycleNumber::at(text, skip(text, definition));
    if (!number) return position;
    const ig_machine_code* const row = of_cycle(number->cycle);
    if (row == nullptr) return position;
    const std::size_t end = statement_end(text, position);
    if (text_.values().is_indexing()) return end;
    if (b.is_raised(is_open_)) b.erase(is_open_);
    text = text.substr(0, end);
    text_.parameters(b, text, number->end, number->cycle, [](std::uint32_t, double) {});
    if (!number->is_first()) return end;
    const auto where = where_of_line(text, position);
    if (row->when == 2 || (row->when == 0 && waits(number->cycle)))
      wait(b, number->cycle);
    else
      answer(b, *row, text, where, position);
    return end;
  }

  ig::Status build(ig::Block& b) const {
    const bool is_answered = answer_call(b);
    const bool calls = recorded_.for_each(b, IG_CODE_CALLS, [&](const ig_machine_code& row) { call(b, row); });
    return calls || is_answered ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// FN 19: PLC=+10/+1 and other functions that reach outside the program.
  std::size_t function(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t digits = skip(text, glued(text, position, "FN")), last = skip_digits(text, digits);
    unsigned number = 0;
    std::from_chars(text.data() + digits, text.data() + last, number);
    static constexpr std::array outside{14u, 15u, 16u, 17u, 19u, 20u, 26u, 27u, 28u, 29u, 37u, 38u};
    if (std::find(outside.begin(), outside.end(), number) == outside.end()) return position;
    const ig_machine_code* const row = machine_.find("FN" + std::to_string(number));
    if (row == nullptr) return position;
    const std::size_t end = statement_end(text, position);
    if (!text_.values().is_indexing()) answer(b, *row, text.substr(0, end), where_of_line(text, position));
    return end;
  }

  /// TCH PROBE 413, and TCH PROBE 0.0 with its further parts.
  std::size_t probing(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t behind = keyword(text, position, "TCH PROBE");
    const auto number = behind == position ? std::nullopt : CycleNumber::at(text, skip(text, behind));
    if (!number) return position;
    const std::string name = "TCH PROBE " + std::to_string(number->cycle);
    const ig_machine_code* row = machine_.find(name);
    if (row == nullptr) row = machine_.family(name);
    if (row == nullptr) return position;
    const std::size_t end = statement_end(text, position);
    if (text_.values().is_indexing()) return end;
    text = text.substr(0, end);
    if (!number->part) text_.parameters(b, text, number->end, number->cycle, [](std::uint32_t, double) {});
    if (number->part.value_or(0) == 0) answer(b, *row, text, where_of_line(text, position), position);
    return end;
  }

  static bool waits(std::uint32_t cycle) { return waits_for_call(cycle) && !acts_where_defined(cycle); }

  void wait(ig::Block& b, std::uint32_t cycle) const {
    definition_.clear(b);
    b.set(number_, static_cast<std::int64_t>(cycle));
    b.erase(said_);
    b.erase(modal_call_);
  }

  /// CYCL CALL, M99 and M89 of a cycle that has a row.
  bool answer_call(ig::Block& b) const {
    const bool is_called = b.has(call_);
    if (!is_called && (!b.has(modal_call_) || b.get(words_).mask == 0)) return false;
    const ig_machine_code* const row = of_cycle(b.get_or(number_, std::int64_t{0}));
    if (row == nullptr) return false;
    b.raise(done_);
    if (is_called)
      b.erase(call_);
    else if (is_inside_cycle(b))
      return true;
    answer(b, *row, {}, ig::Where::block());
    if (b.has(pattern_)) b.report(ig::diag("HEI-0342"), ig::Where::block(), ig::to_view(row->name));
    return true;
  }

  /// M89 does not count in the program that it calls.
  bool is_inside_cycle(const ig::Block& b) const {
    const ig::Flow& flow = text_.values().flow();
    const std::uint32_t depth = flow.frame(b).depth;
    for (std::uint32_t level = 1; level <= depth; ++level)
      if (const auto frame = flow.frame(b, level); frame && frame->tag == called_by_cycle) return true;
    return false;
  }

  void call(ig::Block& b, const ig_machine_code& row) const {
    const std::string_view code = ig::to_view(row.name), program = ig::to_view(row.program);
    report_lost_arguments(b, row, ig::Where::block());
    b.set(term_, b.symbol(code));
    b.set_text(file_name_, program);
    const ig::Flow::Answer answer = ask_program(b, text_.values().flow(), program, called_by_cycle);
    if (answer.is_not_found())
      b.report(ig::diag("HEI-0340"), ig::Where::block(), code, program, answer.reason);
    else if (answer.status == IG_GO_TAKEN)
      b.report(ig::diag("HEI-0341"), ig::Where::block(), code, program);
  }

  const ig_machine_code* of_cycle(std::int64_t number) const {
    return number > 0 && machine_.holds_any() ? row_of_cycle(machine_, static_cast<std::uint32_t>(number)) : nullptr;
  }

  /// `begin` is where the cycle begins in the text.
  void answer(ig::Block& b, const ig_machine_code& row, std::string_view text, ig::Where where,
              std::size_t begin = 0) const {
    record_.add(b, row, where, text.substr(begin),
                [&](std::string_view name) { return text_.values().in_row(b, name, where); });
    for_each_code(row, [&](std::string_view code) { m_.put(b, text_.values(), text, code, where.begin, where.end); });
  }
};

const ig::Register<KlartextMachineCode> klartext_machine_code_syntax;

}  // namespace
}  // namespace heidenhain
