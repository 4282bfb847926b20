// T codes that call O9000 (parameter 6001 bit 5): the number goes to #149, and the program is called after the block
// like a subprogram. The syntax works on the word, so that T#1 is a T code as well.
#include "macro/macro_environment.hpp"
#include "macro/macro_program_call.hpp"

namespace fanuc {
namespace {

struct FanucToolCall {
  static constexpr auto spec = ig::syntax("FanucToolCallSyntax", "T codes that call the program O9000.")
                                   .after("WordSyntax", "FanucMacroWordSyntax", "FanucBlockMacroSyntax")
                                   .before("ParameterizedFlagSyntax", "ToolChangeSyntax");

  ig::Word t_{"Parsing.T", ig::wake, ""};
  MacroFrame frame_;
  ProgramsOfBuilder builder_;
  ig::Config bound_{"isogloss.code-call/1", ig::Need::optional, "The program that T calls, if any."};
  std::optional<double> program_ = bound_.number("T");

  ig::Status build(ig::Block& b) {
    if (!program_ || frame_.is_in_bound_program(b)) return ig::Status::unchanged;
    const auto where = ig::Where::word(t_.id());
    const auto number = b.take(t_);
    if (!number) return ig::Status::unchanged;
    frame_.enter(b);
    if (!frame_.store().set(tool_variable, *number)) b.report(ig::diag("FAN-0109"), where, std::string_view("#149"));
    frame_.note_write(b, tool_variable, *number);
    call_program(b, builder_, frame_.flow, {static_cast<std::int64_t>(*program_)}, 1, called_by_code | shares_locals,
                 where);
    return ig::Status::changed;
  }

 private:
  static constexpr std::uint32_t tool_variable = 149;
};

const ig::Register<FanucToolCall> fanuc_tool_call_syntax;

}  // namespace
}  // namespace fanuc
