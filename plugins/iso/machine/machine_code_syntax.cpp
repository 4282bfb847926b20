// G and M codes for which the table MachineCodes has a row: the row goes before what the dialect knows of the code. The
// words directly behind an M code are its own; the words of a G code are those that UnknownCodeSyntax removes.
#include <string>

#include <isogloss/cnc/block_skip.hpp>
#include <isogloss/cnc/machine_codes.hpp>
#include <isogloss/flow.hpp>

#include "flow/program_of_row.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class Calls { here, passed_on };

struct MachineCodeSyntax {
  static constexpr auto spec = ig::syntax("MachineCodeSyntax", "Codes of the machine's builder, as MachineCodes says.")
                                   .after("HeadIndexSyntax")
                                   .before("FlagSyntax")
                                   .scans("GMgm")
                                   .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0571", "the program {1} that {0} calls is not found, so it is not called: {2}"),
  };

  MachineCodes machine_;
  MachineCodeRecord record_;
  RecordedMachineCodes recorded_;
  CodesOfMachineCodes codes_{machine_};
  ig::Choice<Calls> calls_{"calls", "here|passed-on", "here",
                           "Codes whose rows call a program: called here, or passed on to a syntax of macro calls."};
  ig::Config bound_{"isogloss.code-call/1", ig::Need::optional, "Codes that parameters bind to programs."};
  ig::Signal unknown_code_{"Source.~UnknownCode", ig::write};
  ig::Out<ig::Symbol> term_{"SubProgramCall.Term"};
  ig::Flow flow_;
  SkipLayers layers_;
  ig::Signal has_words_end_{"MachineCode.~WordsEnd", ig::read | ig::write};
  std::size_t words_end_ = 0;  // of the G codes of the block that has raised it

  MachineCodeSyntax() {
    if (!machine_.holds_any()) ig::stay_idle();
  }

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (!machine_.holds_any()) return position;
    const std::size_t number = skip_blanks(text, position + 1), end = number_end(text, number);
    if (end == number || std::string_view("=Oo.").find(at(text, end)) != std::string_view::npos) return position;
    std::string name(1, text[position]);
    const ig_machine_code* const row = row_of(name.append(piece(text, number, end)));
    if (row == nullptr || !b.is_in_turn()) return position;
    if (calls_ == Calls::passed_on && arguments_of(*row) != CodeArguments::none) return position;
    const bool is_g = to_upper(text[position]) == 'G';
    const std::size_t words_end = is_g ? executed_end(b, text, position) : own_words_end(text, end);
    if (!flow_.is_indexing()) record_.add(b, *row, ig::Where::columns(position, end), piece(text, position, words_end));
    if (calls_ == Calls::here && !flow_.is_indexing())
      report_lost_arguments(b, *row, ig::Where::columns(position, end));
    if (row->does == IG_CODE_ACTS) {
      if (codes_.put(b, *row, position, end)) b.raise(unknown_code_);
      return end;
    }
    if (is_g) b.raise(unknown_code_);
    return is_g ? end : words_end;
  }

  ig::Status build(ig::Block& b) const {
    const bool any = recorded_.for_each(b, IG_CODE_CALLS, [&](const ig_machine_code& row) { call(b, row); });
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// A family answers only for codes that nothing else in this chain knows.
  const ig_machine_code* row_of(const std::string& name) const {
    if (const ig_machine_code* const row = machine_.find(name)) return row;
    const bool is_known = codes_.knows(to_upper(name[0]), std::string_view(name).substr(1)) || bound_.number(name);
    return is_known ? nullptr : machine_.family(name);
  }

  void call(ig::Block& b, const ig_machine_code& row) const {
    if (calls_ == Calls::passed_on && arguments_of(row) != CodeArguments::none) return;
    const std::string_view code = ig::to_view(row.name), program = ig::to_view(row.program);
    b.set(term_, b.symbol(code));
    const ig::Flow::Answer answer = call_program_of_row(b, flow_, program);
    if (answer.is_not_found())
      b.report(ig::diag("ISO-0571"), ig::Where::block(), code, program, answer.reason);
    else if (answer.status == IG_GO_TAKEN)
      b.report(ig::diag("ISO-0493"), ig::Where::block(), code);
  }

  /// Where the words end that are executed, looked for once in a block.
  std::size_t executed_end(ig::Block& b, std::string_view text, std::size_t position) {
    if (b.is_raised(has_words_end_)) return words_end_;
    b.raise(has_words_end_);
    return words_end_ = layers_.executed_end(text, position);
  }

  /// The end of 92, 54.1 and 92. with its point. Of "54. 1", which FlagSyntax may join, the end is before the point.
  static std::size_t number_end(std::string_view text, std::size_t number) {
    const std::size_t end = skip_digits(text, number);
    if (end == number || at(text, end) != '.') return end;
    const std::size_t decimals = skip_digits(text, end + 1);
    return decimals == end + 1 && is_digit(at(text, skip_blanks(text, decimals))) ? end : decimals;
  }

  /// M92 P5 Q3: the position after the words that can only be arguments of an M code.
  static std::size_t own_words_end(std::string_view text, std::size_t end) {
    for (;;) {
      const std::size_t word = skip_blanks(text, end);
      if (std::string_view("PQLE").find(to_upper(at(text, word))) == std::string_view::npos || word >= text.size())
        return end;
      const std::size_t value = skip_while(text, word + 1, [](char c) { return c == '-' || c == '+' || is_blank(c); });
      const std::size_t last = value_end(text, value);
      if (last == value) return end;
      end = last;
    }
  }

  /// The end of 5.5, #100, #[#1+2] or [#1*2]: an argument of a code is not computed here. `at` where no value stands.
  static std::size_t value_end(std::string_view text, std::size_t at) {
    const std::size_t behind = skip_while(text, at, [](char c) { return c == '#'; });
    if (ig::cnc::at(text, behind) == '[') {
      int depth = 0;
      for (std::size_t i = behind; i < text.size() && text[i] != '\n'; ++i) {
        depth += text[i] == '[' ? 1 : text[i] == ']' ? -1 : 0;
        if (depth == 0) return i + 1;
      }
      return at;
    }
    const ig::Decimal number = ig::read_decimal(text, behind);
    return number.ok && number.end > behind ? number.end : at;
  }
};

const ig::Register<MachineCodeSyntax> machine_code_syntax;

}  // namespace
}  // namespace iso
