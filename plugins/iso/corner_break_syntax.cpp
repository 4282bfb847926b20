/// ,C and ,R behind a straight move: a chamfer, a rounding at the corner to the next one. Not executed: the corner is
/// run sharp, which is said.
#include "corner_diagnostics.hpp"
#include "scan_util.hpp"

namespace iso {
namespace {

struct CornerBreak {
  static constexpr auto spec = ig::syntax("CornerBreakSyntax", "Says chamfers and roundings of corners: ,C and ,R.")
                                   .after("IsoCommentSyntax")
                                   .before("WordSyntax")
                                   .scans(",");

  ig::Flow flow;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t letter = skip_blanks(text, position + 1);
    const char name = to_upper(at(text, letter));
    if (name != 'C' && name != 'R') return position;
    const std::size_t value = skip_blanks(text, letter + 1);
    const ig::Decimal number = ig::read_decimal(text, value);
    const std::size_t end = number.ok ? number.end : skip_expression(text, value);
    if (end == value) return position;
    if (!flow.is_indexing())
      b.report(corner_diag("ISO-0480"), ig::Where::columns(position, end), piece(text, position, end));
    return end;
  }
};

const ig::Register<CornerBreak> registered;

}  // namespace
}  // namespace iso
