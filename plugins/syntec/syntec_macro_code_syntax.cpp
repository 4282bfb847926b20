/// Codes that call a macro of the machine builder: G200 to G999, and the G, M and T codes that parameters assign to
/// one. The words of the block are its arguments and move no axis. The macro is a file beside the program or in a
/// folder that the user gives; where there is none, its moves are missing, and the code is reported. Codes with two or
/// more decimals (G68.18) belong to robots.
#include <string>

#include <isogloss/cnc/machine_codes.hpp>
#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

#include "macro/macro_codes.hpp"
#include "macro/macro_requests.hpp"

namespace syntec {

using namespace ig::cnc;

namespace {

struct SyntecMacroCode {
  static constexpr auto spec =
      ig::syntax("SyntecMacroCodeSyntax",
                 "Calls the macros of the machine's builder by their codes, with the words of the block.")
          .after("FlagSyntax", "SyntecMacroWordSyntax")
          .before("FanucMacroCallSyntax", "ParameterizedFlagSyntax", "DecimalPointSyntax", "ToolChangeSyntax",
                  "SubprogramCallSyntax")
          .scans("GMgm");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SYN-0002", "{0} calls the macro {1}, which is not executed: its moves are missing"),
      ig::diagnostic(IG_ERROR, "SYN-0077",
                     "{0} calls the macro {1}, which is not executed: the block makes another call"),
  };

  /// The words that a macro takes from its block: a G macro with one axis takes all, an M code takes all but T.
  static constexpr std::string_view of_g = "XYZABCIJKUVWPQRLE", of_m = "XYZABCIJKUVWPQRLEDFHS";

  ig::Word tool_{"Parsing.T", ig::read | ig::wake};
  ig::Signal called_{"Parsing.~BuilderMacro", ig::read | ig::write | ig::wake};
  MachineCodes machine_;  // a row of a code goes before the builder's macro
  ig::Config macros_{"isogloss.code-call/1", ig::Need::optional, "The codes that call a macro, and its number."};
  bool tool_calls_ = macros_.number("T").has_value();
  SharedScan scan_;
  BlockArguments arguments_;
  MacroEnvironment environment_;
  std::vector<WordCall> found_;  // in a block in ISO format
  bool is_found_ = false;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    const ig::Decimal code = ig::read_decimal(text, skip_blanks(text, position + 1));
    if (!code.ok || code.value < 0 || code.value > 99'999 || at(text, code.end) == '=') return position;
    const char letter = to_upper(text[position]);
    const std::string name = macro_code_name(letter, piece(text, skip_blanks(text, position + 1), code.end));
    if (!macros_.number(name) || machine_.find(name) != nullptr) return position;
    if (environment_.flow.is_indexing()) return code.end;
    environment_.enter(b);
    if (!calls_macro(name, environment_.store().level().caller)) return position;
    if (!b.is_raised(called_)) found_.clear();
    const bool is_of_robot = letter == 'G' && code.value < 200 && code.decimals > 1;
    found_.push_back({name, is_of_robot ? std::string() : macro_code_file(name), position, code.end});
    b.raise(called_);
    return code.end;
  }

  ig::Status build(ig::Block& b) {
    const bool has_tool = tool_calls_ && b.has(tool_) && b.is_fresh(tool_.id());
    if (!b.is_raised(called_) && !has_tool) return ig::Status::unchanged;
    environment_.enter(b);
    is_found_ = false;
    const Arguments given = arguments_.read(b, scan_);
    if (b.is_raised(called_)) call_codes(b, given);
    if (has_tool) call_tool(b, given);
    return ig::Status::changed;
  }

 private:
  /// Of several G macros of a block the control executes the last one, of several M macros the first.
  void call_codes(ig::Block& b, const Arguments& given) {
    const std::vector<WordCall>& calls = arguments_.is_macro(b) ? scan_->calls : found_;
    const WordCall *last_g = nullptr, *first_m = nullptr;
    bool any_m = false;
    for (const WordCall& c : calls) {
      if (c.code == "G65" || c.code.starts_with("G66")) continue;
      any_m |= c.code[0] == 'M';
      if (c.file.empty()) {
        b.report(ig::diag("SYN-0003"), c.where(), std::string_view(c.code),
                 "it belongs to robots and signals; its words are not executed either");
      } else if (c.code[0] == 'G') {
        last_g = &c;
      } else if (first_m == nullptr) {
        first_m = &c;
      }
    }
    const WordCall* const chosen = last_g != nullptr ? last_g : first_m;
    for (const WordCall& c : calls)
      if (&c != chosen && !c.file.empty())
        b.report(ig::diag("SYN-0077"), c.where(), std::string_view(c.code), std::string_view(c.file));
    if (chosen != nullptr) call(b, *chosen, given, chosen->code[0] == 'G' ? Caller::g_code : Caller::m_code);
    arguments_.take(b, any_m ? of_m : of_g);
  }

  void call(ig::Block& b, const WordCall& c, const Arguments& given, Caller caller) {
    const auto repeats = repeats_of(b, given.letters[letter_index('L')], c.code, c.where());
    if (!repeats || *repeats == 0) return;
    const std::uint64_t tag = environment_.store().enter(given, caller);
    settle(b, request_call(b, environment_.flow, 0, c.file, *repeats, tag), c);
  }

  /// Pr3215 is 2: T0000 is a macro; 1: it is a subprogram, with the variables of the caller.
  void call_tool(ig::Block& b, const Arguments& given) {
    const Caller running = environment_.store().level().caller;
    if (running == Caller::m_code || running == Caller::t_code) return;
    ig_word word{};
    const bool has_place = b.word(tool_.id(), word);
    const WordCall c{"T", "T0000", has_place ? word.begin : 0u, has_place ? word.end : 0u};
    if (is_found_) return b.report(ig::diag("SYN-0077"), c.where(), std::string_view("T"), std::string_view(c.file));
    const bool is_macro = environment_.parameter(3215) != std::optional(1.0);
    const std::uint64_t tag = is_macro ? environment_.store().enter(given, Caller::t_code) : 0;
    settle(b, request_call(b, environment_.flow, 0, c.file, 1, tag), c);
  }

  void settle(ig::Block& b, const ig::Flow::Answer& answer, const WordCall& c) {
    is_found_ = answer.is_done();
    if (answer.is_done()) return;
    environment_.store().leave_last();
    if (answer.is_not_found())
      b.report(ig::diag("SYN-0002"), c.where(), std::string_view(c.code), std::string_view(c.file));
    else if (answer.status == IG_GO_TAKEN)
      b.report(ig::diag("SYN-0077"), c.where(), std::string_view(c.code), std::string_view(c.file));
  }
};

const ig::Register<SyntecMacroCode> syntec_macro_code_syntax;

}  // namespace
}  // namespace syntec
