// Statements of macro languages: assignments, conditions, loops, jumps, O-words, output commands. Each is recognised as
// a whole, so that none of its parts is read as a word, and becomes a leftover for evaluation. Where no syntax
// evaluates it, inspection reports that it is not executed.
#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

constexpr std::string_view keywords[] = {"IF",    "THEN",  "ELSE",  "WHILE", "DO",    "END",    "GOTO", "ENDIF",
                                         "DPRNT", "BPRNT", "POPEN", "PCLOS", "SETVN", "RETURN", "CALL"};

struct MacroStatementSyntax {
  static constexpr auto spec =
      ig::syntax("MacroStatementSyntax", "Recognises macro statements, which evaluation executes.")
          .after("IsoCommentSyntax", "HeadIndexSyntax", "ProgramNumberSyntax")
          .before("WordSyntax")
          .scans("#IWDEGTOBPSRCiwdegtobpsrc")
          .scans_ahead();

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (!begins_statement(text, position)) return position;
    const std::size_t end = statement_end(text, position);
    leave(b, IG_LEFT_STATEMENT, piece(text, position, end), position, end);
    return end;
  }

 private:
  static bool begins_statement(std::string_view text, std::size_t position) {
    const char c = text[position];
    if (c == '#') return true;  // the # of a word's value is read with its word
    const char second = at(text, position + 1);
    if (to_upper(c) == 'O') {
      if (second != '<' && second != '#' && second != '[' && second != ' ' && !is_digit(second)) return false;
      return begins_o_word(text, position) && stands_first(text, position);
    }
    if (!is_letter(second)) return false;
    const std::string_view word = piece(text, position, skip_name_of(text, position, is_letter));
    for (const std::string_view keyword : keywords)
      if (equals_ignoring_case(word, keyword)) return stands_first(text, position);
    return false;
  }

  /// The end of the statement: a comment or semicolon after it. The parentheses of #3000=1(ALARM TEXT) belong to it.
  static std::size_t statement_end(std::string_view text, std::size_t position) {
    const std::string_view variable = piece(text, position, skip_digits(text, position + 1));
    const bool has_message = variable == "#3000" || variable == "#3006";
    std::size_t end = skip_while(
        text, position, [&](char c) { return c != ';' && c != '\r' && c != '\n' && (c != '(' || has_message); });
    while (is_blank(text[end - 1])) --end;
    return end;
  }
};

const ig::Register<MacroStatementSyntax> macro_statement_syntax;

}  // namespace
}  // namespace iso
