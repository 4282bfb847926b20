// Macro calls: G65 once, G66 after each block that moves, G66.1 for each block, and the codes that parameters assign to
// macros. The scanner reads the arguments itself, because words have another meaning in a call: I J K may be there ten
// times.
#include <isogloss/cnc/code_fields.hpp>
#include "macro/macro_call_words.hpp"
#include "macro/macro_environment.hpp"
#include "macro/macro_program_call.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

enum class OwnBlock { calls, waits };

constexpr std::uint32_t largest_number = 99'999'999;

struct FanucMacroCall {
  static constexpr auto spec =
      ig::syntax("FanucMacroCallSyntax", "Macro calls: G65, G66, G66.1, and codes bound to macros by parameters.")
          .after("FlagSyntax")
          .before("WordSyntax")
          .scans("GMgm");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "FAN-0161", "{0} has no P with the number of a program: no macro is called"),
      ig::diagnostic(IG_ERROR, "FAN-0162",
                     "{0} P{1} is not a program number, so no macro is called: write 1 to 99999999"),
      ig::diagnostic(IG_ERROR, "FAN-0163", "'{0}' is not an argument of a macro call: it is not passed"),
      ig::diagnostic(IG_ERROR, "FAN-0164", "this call has more than ten sets of I J K: '{0}' is not passed"),
      ig::diagnostic(IG_ERROR, "FAN-0167",
                     "{0} L{1} is not a number of calls: write a whole number from 0 to 99999999"),
      ig::diagnostic(IG_ERROR, "FAN-0171",
                     "this G66 is not executed: {0} modal calls are in force, and the control nests {1} macro calls"),
      ig::diagnostic(IG_WARNING, "FAN-0172", "{0} has L0, so the macro is not called: leave L out for one call"),
      ig::diagnostic(IG_WARNING, "FAN-0174", "{0} stands more than once in this call: the last one counts"),
  };

  ig::Choice<IjkSets> ijk_sets_{"ijk-sets", "automatic|one", "automatic",
                                "A second I, J or K begins the next set, #7 #8 #9, or replaces the first one."};
  ig::Choice<Slashes> slashes_{"slashes", "none|comment", "none",
                               "What // among the arguments means: two signs of block skip, or a comment."};
  ig::IntegerOption nesting_{"nesting", "5", {1, 99}, "How deep the control lets macro calls nest."};
  ig::Choice<OwnBlock> own_block_{"each-block-call", "calls|waits", "calls",
                                  "Whether the block of G66.1 itself calls the macro, with its arguments."};
  CodeFields codes_;
  MacroEnvironment environment_;
  ProgramsOfBuilder builder_;
  MachineCodes machine_;
  MachineCodeRecord record_;
  ig::Config bound_{"isogloss.code-call/1", ig::Need::optional, "The programs that codes call."};
  ArgumentUnits units_;
  BlockSkip block_skip_;  // this syntax reads its block to the end, past the scanner of the sign
  ig::Signal call_{"Parsing.~MacroCall", ig::read | ig::write | ig::wake};
  ig::Signal modal_{"MacroCall.~Modal", ig::write, ig::Life::modal};

  FanucMacroCall() { environment_.store().settings.call_nesting = static_cast<std::uint32_t>(nesting_); }

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    const ig::Decimal number = ig::read_decimal(text, skip_blanks(text, position + 1));
    const auto index = number.ok ? CodeFields::index_of(number.value) : std::nullopt;
    if (!index) return position;
    if (environment_.flow.is_indexing()) return block_end(text, position);
    const char letter = to_upper(text[position]);
    begin_ = position;
    code_end_ = number.end;
    code_ = {letter, *index};
    const std::string_view code = code_.text();
    const bool is_g65 = code == "G65", each_block = code == "G66.1", is_modal = code == "G66" || each_block;
    if (b.is_raised(call_)) {
      b.report(ig::diag("FAN-0170"), ig::Where::columns(position, number.end), code);
      return block_end(text, position);
    }
    is_modal_ = is_modal;
    each_block_ = each_block;
    tag_bits_ = 0;
    words_ = {};
    row_ = nullptr;
    if (!is_g65 && !is_modal) {
      const bool is_in_bound = environment_.is_in_bound_program(b);
      const ig_machine_code* const row = is_in_bound ? nullptr : row_of(code);
      const auto program = row == nullptr ? bound_.number(code) : std::nullopt;
      if (row != nullptr) {
        const CalledProgram called = program_of_row(*row);
        words_.has_program = true;
        words_.program = static_cast<double>(called.number);
        words_.name = called.name;
        tag_bits_ = called_by_code;
        row_ = row;
      } else if (!program || is_in_bound) {
        codes_.set(b, letter, *index, position, number.end);
        return number.end;
      }
      if (program) {
        words_.has_program = true;
        words_.program = std::fabs(*program);
        is_modal_ = *program < 0;
        tag_bits_ = called_by_code;
      }
      if (program && words_.program < first_macro) {
        tag_bits_ |= shares_locals;
        b.raise(call_);
        return number.end;
      }
    }
    environment_.enter(b);
    MacroCallReader reader(b, text, environment_, units_, block_skip_, ijk_sets_, slashes_, words_);
    using Names = MacroCallReader::Names;
    end_ = reader.read(number.end, tag_bits_ == 0 ? Names::accepted : Names::refused);
    if (row_ != nullptr) record_.add(b, *row_, ig::Where::columns(position, end_), piece(text, position, end_));
    b.raise(call_);
    return reader.rest();
  }

  ig::Status build(ig::Block& b) {
    if (!b.is_raised(call_)) return ig::Status::unchanged;
    environment_.enter(b);
    const auto where = ig::Where::columns(begin_, end_);
    if ((tag_bits_ & shares_locals) != 0) {
      call_program(b, builder_, environment_.flow, words_.called(), 1, tag_bits_,
                   ig::Where::columns(begin_, code_end_));
      return ig::Status::changed;
    }
    const std::string_view code = code_.text();
    const double program = words_.program, repeats = words_.repeats;
    if (!words_.has_program) {
      b.report(ig::diag("FAN-0161"), where, code);
    } else if (words_.name.empty() && (program < 1 || program > largest_number || program != std::floor(program))) {
      b.report(ig::diag("FAN-0162"), where, code, program);
    } else if (repeats < 0 || repeats > largest_number || repeats != std::floor(repeats)) {
      b.report(ig::diag("FAN-0167"), where, code, repeats);
    } else if (repeats == 0) {
      b.report(ig::diag("FAN-0172"), where, code);
    } else if (is_modal_) {
      keep_modal_call(b, where);
    } else {
      call_macro(b, where, false);
    }
    return ig::Status::changed;
  }

 private:
  static constexpr double first_macro = 9010;  ///< M codes call O9001 to O9009 like subprograms

  /// The row that calls a program for the code, with arguments. A family answers for no code that has a meaning here.
  const ig_machine_code* row_of(std::string_view code) const {
    const ig_machine_code* row = machine_.find(code);
    if (row == nullptr && !bound_.number(code) && !codes_.knows(code)) row = machine_.family(code);
    return row != nullptr && arguments_of(*row) != CodeArguments::none ? row : nullptr;
  }

  /// Each modal call in force adds one level for the macros of the calls before it.
  void keep_modal_call(ig::Block& b, ig::Where where) {
    MacroStore& store = environment_.store();
    std::vector<MacroStore::ModalCall>& calls = store.modal_calls();
    if (static_cast<std::int64_t>(store.depth() + calls.size()) >= nesting_) {
      b.report(ig::diag("FAN-0171"), where, static_cast<double>(calls.size()), static_cast<double>(nesting_));
      b.alarm();
      return;
    }
    calls.push_back({words_.called(), static_cast<std::int64_t>(words_.repeats), words_.arguments, each_block_});
    b.raise(modal_);
    if (each_block_ && own_block_ == OwnBlock::calls) call_macro(b, where, true);
  }

  void call_macro(ig::Block& b, ig::Where where, bool is_modal) {
    MacroStore& store = environment_.store();
    report_deep_call(b, store, where);
    const std::uint64_t tag = store.enter(words_.arguments, is_modal);
    environment_.note_arguments(b, tag, words_.arguments);
    const ig::Flow::Answer answer =
        ask_program(b, builder_, environment_.flow, words_.called(), static_cast<std::int64_t>(words_.repeats),
                    tag | tag_bits_, where, words_.arguments);
    if (is_modal)
      settle_modal(store, answer);
    else if (!answer.is_done())
      store.leave_last();
  }

  // What scan() has read, for build().
  std::size_t begin_ = 0, code_end_ = 0, end_ = 0;
  CodeName code_;
  bool is_modal_ = false, each_block_ = false;
  std::uint64_t tag_bits_ = 0;
  MacroCallWords words_;
  const ig_machine_code* row_ = nullptr;  // of MachineCodes, for a code that calls with arguments
};

const ig::Register<FanucMacroCall> fanuc_macro_call_syntax;

}  // namespace
}  // namespace fanuc
