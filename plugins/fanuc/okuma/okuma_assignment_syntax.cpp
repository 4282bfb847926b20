/// Assignments to an Okuma's variables, VC1=VS27, XPOS=10, VZOFZ[1]=VC35: recognised as a whole, so that the C of VC1
/// is not read as a rotary axis. They are not executed.
#include <isogloss/cnc/scan.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

struct OkumaAssignment {
  static constexpr auto spec =
      ig::syntax("OkumaAssignmentSyntax", "Recognises assignments to variables of an Okuma, which are not executed.")
          .after("IsoCommentSyntax", "HeadIndexSyntax", "ProgramNumberSyntax")
          .before("WordSyntax")
          .scans("ABCDEFGHIJKLMNPQRSTUVWXYZ")
          .scans_ahead();

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (!ig::cnc::is_letter(ig::cnc::at(text, position + 1)) || !stands_first(text, position)) return position;
    std::size_t equals = skip_while(text, position, [](char c) { return ig::cnc::is_letter(c) || is_digit(c); });
    if (ig::cnc::at(text, equals) == '[')
      equals = skip_while(text, equals, [](char c) { return c != ']' && c != '='; });
    if (ig::cnc::at(text, equals) == ']') ++equals;
    if (ig::cnc::at(text, ig::cnc::skip_blanks(text, equals)) != '=') return position;
    std::size_t end = skip_while(text, position, [](char c) { return c != '(' && c != '\r' && c != '\n'; });
    while (is_blank(text[end - 1])) --end;
    leave(b, IG_LEFT_STATEMENT, ig::cnc::piece(text, position, end), position, end);
    return end;
  }
};

const ig::Register<OkumaAssignment> okuma_assignment_syntax;

}  // namespace
}  // namespace fanuc
