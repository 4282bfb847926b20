/// Reads ,C and ,R after a move: a chamfer or a rounding at the corner to the next move. CornerBreakSizeSyntax
/// interprets the number.
#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct CornerBreak {
  static constexpr auto spec = ig::syntax("CornerBreakSyntax", "Reads chamfers and roundings of corners: ,C and ,R.")
                                   .after("IsoCommentSyntax")
                                   .before("WordSyntax")
                                   .scans(",");

  ig::Field<double> chamfer_{"Parsing.CornerBreak.C", ig::read | ig::write, {ig::Life::standard, "mm", ""}};
  ig::Field<double> rounding_{"Parsing.CornerBreak.R", ig::read | ig::write, {ig::Life::standard, "mm", ""}};
  ig::Signal without_point_{"Parsing.~WithoutPoint", ig::write};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t letter = skip_blanks(text, position + 1);
    const char name = to_upper(at(text, letter));
    if (name != 'C' && name != 'R') return position;
    const ig::Decimal number = ig::read_decimal(text, skip_blanks(text, letter + 1));
    if (!number.ok || at(text, number.end) == '.') return position;
    const ig_field field = (name == 'C' ? chamfer_ : rounding_).id();
    if (b.has(field))
      b.report(ig::diag("ISO-0108"), ig::Where::columns(position, number.end),
               std::string_view(name == 'C' ? ",C" : ",R"));
    const bool bare = !number.has_point && number.value != 0;
    const ig_word word{.field = field,
                       .begin = column(position),
                       .end = column(number.end),
                       .value = {.number = number.value + 0.0},
                       .flags = bare ? static_cast<std::uint32_t>(IG_WORD_WITHOUT_POINT) : 0u,
                       .reserved = 0};
    b.set_word(word);
    if (bare) b.raise(without_point_);
    return number.end;
  }
};

const ig::Register<CornerBreak> corner_break_syntax;

}  // namespace
}  // namespace iso
