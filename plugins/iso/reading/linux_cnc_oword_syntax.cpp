/// `o100 sub`, `O<name> call`, `o101 while [...]`: the O-words of LinuxCNC. No dialect here executes them, and the text
/// after the first one has no meaning without them, so the run stops there.
#include <algorithm>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct LinuxCncOWord {
  static constexpr auto spec = ig::syntax("LinuxCncOWordSyntax", "Stops the run at the first O-word of LinuxCNC.")
                                   .before("ProgramNumberSyntax", "MacroStatementSyntax", "WordSyntax")
                                   .scans("Oo");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0541",
                     "'{0}' is an O-word of LinuxCNC, which no dialect here supports: the run stops at this block"),
  };

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (!stands_first(text, position) || !begins_o_word(text, position)) return position;
    const std::size_t end = block_end(text, position);
    const std::string_view word = trim(piece(text, position, std::min(end, text.find(';', position))));
    b.report(ig::diag("ISO-0541"), ig::Where::columns(position, position + word.size()), word);
    b.end_program();
    b.flow(IG_FLOW_END_FILE);
    return end;
  }
};

const ig::Register<LinuxCncOWord> linux_cnc_oword_syntax;

}  // namespace
}  // namespace iso
