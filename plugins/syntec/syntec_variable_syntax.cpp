/// Global variables, `@1`, belong to files in MACRO format. A statement that begins with one is left as a whole, so
/// that it is said once; behind the letter of a word, which has been said to have no number, it is taken with it.
#include <isogloss/sdk.hpp>

#include "scan_util.hpp"

namespace syntec {
namespace {

struct SyntecVariable {
  static constexpr auto spec =
      ig::syntax("SyntecVariableSyntax", "Leaves variables such as @1, so that each is said once.")
          .after("IsoCommentSyntax")
          .before("FlagSyntax", "WordSyntax")
          .scans("@");

  /// Only the first @ of a block can begin it, and a long block may hold thousands.
  ig::Signal seen_{"Parsing.~AtSign", ig::read | ig::write};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const bool is_first = !b.is_raised(seen_);
    b.raise(seen_);
    if (is_first && iso::stands_first(text, position)) {
      std::size_t end = iso::skip_while(text, position, [](char c) { return c != ';' && c != '\r' && c != '\n'; });
      end = std::min(end, text.find("//", position));
      while (iso::is_blank(text[end - 1])) --end;
      iso::leave(b, IG_LEFT_STATEMENT, iso::piece(text, position, end), position, end);
      return end;
    }
    const std::size_t end = variable_end(text, position);
    std::size_t before = position;
    while (before > 0 && iso::is_blank(text[before - 1])) --before;
    if (before == 0 || !iso::is_letter(text[before - 1]))
      iso::leave(b, IG_LEFT_STATEMENT, iso::piece(text, position, end), position, end);
    return end;
  }

 private:
  /// @12, @[10+#3]
  static std::size_t variable_end(std::string_view text, std::size_t position) {
    if (iso::at(text, position + 1) == '[') return iso::skip_bracketed(text, position + 1);
    return iso::skip_digits(text, position + 1);
  }
};

const ig::Register<SyntecVariable> syntec_variable_syntax;

}  // namespace
}  // namespace syntec
