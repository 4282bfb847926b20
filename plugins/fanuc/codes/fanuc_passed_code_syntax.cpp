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
  ig::Signal row_{"PassedCode.~Row", ig::read | ig::write};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (macros_.flow.is_indexing()) return position;
    const char letter = to_upper(text[position]);
    if (letter == 'N')
      keep(b, n_, text, position);
    else if (letter == 'M' || !stands_alone(text, position))
      read_row(b, text, position);
    return position;
  }

  ig::Status build(ig::Block& b) const {
    const std::optional<double> m = take(b, m_), n = take(b, n_);
    if (!m && !n) return ig::Status::unchanged;
    mark_.keep(b, macros_.store(), m, n);
    return ig::Status::changed;
  }

 private:
  /// Is no other code next to this G? So it is in most blocks.
  static bool stands_alone(std::string_view text, std::size_t position) {
    const char next = to_upper(at(text, skip_while(text, position + 1, is_part_of_code)));
    return next != 'G' && next != 'M';
  }

  /// Adjacent G and M codes are read here as one row, as in FlagSyntax, which does not stop between them. N stands
  /// alone. Where another syntax stops between the codes, a long row is not read again from each of them.
  [[gnu::noinline]] void read_row(ig::Block& b, std::string_view text, std::size_t position) {
    if (position < row_end_ && b.is_raised(row_)) return;
    std::size_t next = position;
    while (next < text.size()) {
      const char letter = to_upper(text[next]);
      if (letter != 'G' && letter != 'M') break;
      if (letter == 'G' && is_digit(at(text, next + 1))) {  // FlagSyntax reads the code, and joins "G54. 1"
        next = skip_while(text, next + 2, is_part_of_code);
        continue;
      }
      const std::size_t begin = ig::cnc::skip_blanks(text, next + 1);
      const std::size_t end = letter == 'M' ? keep(b, m_, text, next) : skip_while(text, begin, is_part_of_code);
      if (end <= begin) break;
      next = ig::cnc::skip_blanks(text, end);
    }
    if (next - position <= short_row) return;
    b.raise(row_);
    row_end_ = next;
  }

  static constexpr std::size_t short_row = 100;
  static constexpr bool is_part_of_code(char c) { return is_digit(c) || c == '.' || is_blank(c); }

  /// Keeps the number behind the letter at `position`; returns its end, or the place of the letter.
  std::size_t keep(ig::Block& b, const ig::Field<double>& field, std::string_view text, std::size_t position) const {
    const ig::Decimal number = ig::read_decimal(text, ig::cnc::skip_blanks(text, position + 1));
    if (!number.ok) return position;
    b.set(field, number.value);
    return number.end;
  }

  static std::optional<double> take(ig::Block& b, const ig::Field<double>& field) {
    ig_value value;
    return b.take(field.id(), value) ? std::optional(value.number) : std::nullopt;
  }

  std::size_t row_end_ = 0;  // of the block that has raised row_
};

const ig::Register<FanucPassedCode> fanuc_passed_code_syntax;

}  // namespace
}  // namespace fanuc
