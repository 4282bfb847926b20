/// Records the last M code and the last sequence number that the program has passed, for #4113 and #4114. It reads the
/// text without taking it, because a code that no syntax knows is recorded, too.
#include <isogloss/cnc/scan.hpp>

#include "macro/macro_environment.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

struct FanucPassedCode {
  static constexpr auto spec =
      ig::syntax("FanucPassedCodeSyntax", "Keeps the last M code and sequence number: #4113, #4114.")
          .after("BlockSkipSyntax", "IsoCommentSyntax")
          .before("HeadIndexSyntax", "FlagSyntax")
          .scans("GMNgmn");

  MacroFrame macros_;
  PassedCodeMark mark_;

  /// Adjacent G and M codes are read here as one row, as in FlagSyntax.
  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (macros_.flow.is_indexing()) return position;
    std::size_t next = position;
    while (next < text.size()) {
      const char letter = to_upper(text[next]);
      if (letter != 'G' && letter != 'M' && letter != 'N') break;
      const std::size_t begin = ig::cnc::skip_blanks(text, next + 1);
      std::size_t end = begin;
      if (letter == 'G') {  // only passed over, so its number is not read; FlagSyntax joins "G54. 1"
        end = skip_while(text, begin, [](char c) { return is_digit(c) || c == '.' || is_blank(c); });
      } else if (const ig::Decimal number = ig::read_decimal(text, begin); number.ok) {
        mark_.note(b, macros_.store(), letter, number.value);
        end = number.end;
      }
      if (end == begin) break;
      next = ig::cnc::skip_blanks(text, end);
    }
    return position;
  }
};

const ig::Register<FanucPassedCode> fanuc_passed_code_syntax;

}  // namespace
}  // namespace fanuc
