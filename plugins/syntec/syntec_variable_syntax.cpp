/// Global variables, `@1`, belong to files in MACRO format. A statement that begins with one becomes a leftover as a
/// whole, so that it is reported once. After the letter of a word, which has been reported to have no number, the
/// variable is taken with it.
#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace syntec {

using namespace ig::cnc;

namespace {

struct SyntecVariable {
  static constexpr auto spec =
      ig::syntax("SyntecVariableSyntax",
                 "Leaves a variable such as @1 unread as one piece, so that it is reported once.")
          .after("IsoCommentSyntax")
          .before("FlagSyntax", "WordSyntax")
          .scans("@");

  /// Only the first @ of a block can begin a statement, and a long block may hold thousands of them.
  ig::Signal seen_{"Parsing.~AtSign", ig::read | ig::write};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const bool is_first = !b.is_raised(seen_);
    b.raise(seen_);
    if (is_first && stands_first(text, position)) {
      std::size_t end = skip_while(text, position, [](char c) { return c != ';' && c != '\r' && c != '\n'; });
      end = std::min(end, text.find("//", position));
      while (is_blank(text[end - 1])) --end;
      leave(b, IG_LEFT_STATEMENT, piece(text, position, end), position, end);
      return end;
    }
    const std::size_t end = variable_end(text, position);
    std::size_t before = position;
    while (before > 0 && is_blank(text[before - 1])) --before;
    if (before == 0 || !is_letter(text[before - 1]))
      leave(b, IG_LEFT_STATEMENT, piece(text, position, end), position, end);
    return end;
  }

 private:
  /// @12, @[10+#3]
  static std::size_t variable_end(std::string_view text, std::size_t position) {
    if (at(text, position + 1) == '[') return skip_bracketed(text, position + 1);
    return skip_digits(text, position + 1);
  }
};

const ig::Register<SyntecVariable> syntec_variable_syntax;

}  // namespace
}  // namespace syntec
