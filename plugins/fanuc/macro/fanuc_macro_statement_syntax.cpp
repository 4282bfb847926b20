/// Macro statements: assignments, IF, GOTO, WHILE, alarms, output. The scanner takes the statement as a whole, so that
/// no part of it is read as a word; build() executes it on the text, which is quicker than keeping parsed expressions.
#include "macro/macro_execution.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

struct FanucMacroStatement {
  static constexpr auto spec =
      ig::syntax("FanucMacroStatementSyntax", "Macro statements: assignments, IF, WHILE, GOTO, alarms and output.")
          .after("IsoCommentSyntax", "HeadIndexSyntax", "ProgramNumberSyntax")
          .before("WordSyntax")
          .scans("[#IWDEGTOBPSRCiwdegtobpsrc")
          .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "FAN-0121", "{0} is read-only on this control: nothing is assigned"),
      ig::diagnostic(IG_ERROR, "FAN-0122", "the tables of this run have no row for {0}: nothing is written"),
      ig::diagnostic(IG_ERROR, "FAN-0123", "'{0}' does not belong here: the statement is not executed"),
      ig::diagnostic(IG_ERROR, "FAN-0124", "the statement has no =: nothing is assigned"),
      ig::diagnostic(IG_ERROR, "FAN-0125",
                     "the macro statement '{0}' follows other words: it is not executed; give it its own block"),
      ig::diagnostic(IG_ERROR, "FAN-0131", "{0} is incomplete: {1} is missing; nothing is executed"),
      ig::diagnostic(IG_ERROR, "FAN-0132", "'{0}' is not a valid sequence number: the jump is not executed"),
      ig::diagnostic(IG_ERROR, "FAN-0133", "N{0} is not found, so the jump is not executed: {1}"),
      ig::diagnostic(IG_ERROR, "FAN-0134", "{0}{1} is not executed: loops are numbered from 1 to {2}"),
      ig::diagnostic(IG_ERROR, "FAN-0135", "END{0} of this loop is not found, so the loop is not skipped: {1}"),
      ig::diagnostic(IG_ERROR, "FAN-0136", "END{0} belongs to no open DO{0}: the run continues after END{0}"),
      ig::diagnostic(IG_ERROR, "FAN-0137", "END{0} crosses the loop DO{1} of line {2}: end the inner loop first"),
      ig::diagnostic(IG_ERROR, "FAN-0138", "DO{0} stands inside DO{0} of line {1}: give the inner loop another number"),
      ig::diagnostic(IG_ERROR, "FAN-0139", "alarm {0}: {1}"),
      ig::diagnostic(IG_NOTE, "FAN-0140", "the program stops and shows: {0}"),
      ig::diagnostic(IG_WARNING, "FAN-0143",
                     "words follow THEN, where the control permits only a macro statement: they are executed here"),
      ig::diagnostic(IG_ERROR, "FAN-0144",
                     "DO{0} has no END{0} before its program ends: the blocks after DO{0} are run once"),
      ig::diagnostic(IG_WARNING, "FAN-0173",
                     "the program waits for #{0}, whose state is not known here: the wait loop is skipped"),
  };

  MacroExecution execution_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    return execution_.scan(b, text, position);
  }
  ig::Status restart(ig::Block&) { return execution_.restart(); }
  ig::Status build(ig::Block& b) { return execution_.build(b); }
};

const ig::Register<FanucMacroStatement> fanuc_macro_statement_syntax;

}  // namespace
}  // namespace fanuc
