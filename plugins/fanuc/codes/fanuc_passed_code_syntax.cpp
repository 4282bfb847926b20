/// Keeps the last M code and the last sequence number that the program has passed, for #4113 and #4114. It reads the
/// text without taking it, because a code that no syntax knows is kept, too.
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
          .scans("GMNgmn")
          .scans_ahead();

  MacroFrame macros_;
  ig::Field<double> m_{
      "PassedCode.M", ig::take | ig::write | ig::wake, {ig::Life::block, "", "The M code found last."}};
  ig::Field<double> n_{"PassedCode.N", ig::take | ig::write | ig::wake, {ig::Life::block, "", "The N found last."}};
  PassedCodeMark mark_{ig::read | ig::write};

  /// Adjacent G and M codes are read here as one row, as in FlagSyntax.
  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (macros_.flow.is_indexing()) return position;
    std::size_t next = position;
    while (next < text.size()) {
      const char letter = to_upper(text[next]);
      if (letter != 'G' && letter != 'M' && letter != 'N') break;
      if (letter == 'G' && is_digit(at(text, next + 1))) {  // passed over alone; FlagSyntax joins "G54. 1"
        next = skip_while(text, next + 2, [](char c) { return is_digit(c) || c == '.' || is_blank(c); });
        continue;
      }
      const std::size_t begin = ig::cnc::skip_blanks(text, next + 1);
      std::size_t end = begin;
      if (letter == 'G') {
        end = skip_while(text, begin, [](char c) { return is_digit(c) || c == '.' || is_blank(c); });
      } else if (const ig::Decimal number = ig::read_decimal(text, begin); number.ok) {
        b.set(letter == 'M' ? m_ : n_, number.value);
        end = number.end;
      }
      if (end == begin) break;
      next = ig::cnc::skip_blanks(text, end);
    }
    return position;
  }

  ig::Status build(ig::Block& b) const {
    const std::optional<double> m = take(b, m_), n = take(b, n_);
    if (!m && !n) return ig::Status::unchanged;
    mark_.keep(b, macros_.store(), m, n);
    return ig::Status::changed;
  }

 private:
  static std::optional<double> take(ig::Block& b, const ig::Field<double>& field) {
    ig_value value;
    return b.take(field.id(), value) ? std::optional(value.number) : std::nullopt;
  }
};

const ig::Register<FanucPassedCode> fanuc_passed_code_syntax;

}  // namespace
}  // namespace fanuc
