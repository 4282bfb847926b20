/// Assignments to an Okuma's variables, VC1=VS27, XPOS=10, VZOFZ[1]=VC35: recognised as a whole, so that the C of VC1
/// is not taken for an axis that turns. They are not executed.
#include "scan_util.hpp"

namespace fanuc {
namespace {

struct OkumaAssignment {
  static constexpr auto spec =
      ig::syntax("OkumaAssignmentSyntax", "Recognises assignments to variables of an Okuma, which are not executed.")
          .after("IsoCommentSyntax", "HeadIndexSyntax", "ProgramNumberSyntax")
          .before("WordSyntax")
          .scans("ABCDEFGHIJKLMNPQRSTUVWXYZ");

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (!iso::is_letter(iso::at(text, position + 1)) || !iso::stands_first(text, position)) return position;
    std::size_t equals = iso::skip_while(text, position, [](char c) { return iso::is_letter(c) || iso::is_digit(c); });
    if (iso::at(text, equals) == '[')
      equals = iso::skip_while(text, equals, [](char c) { return c != ']' && c != '='; });
    if (iso::at(text, equals) == ']') ++equals;
    if (iso::at(text, iso::skip_blanks(text, equals)) != '=') return position;
    std::size_t end = iso::skip_while(text, position, [](char c) { return c != '(' && c != '\r' && c != '\n'; });
    while (iso::is_blank(text[end - 1])) --end;
    iso::leave(b, IG_LEFT_STATEMENT, iso::piece(text, position, end), position, end);
    return end;
  }
};

const ig::Register<OkumaAssignment> okuma_assignment_syntax;

}  // namespace
}  // namespace fanuc
