// The sequence number N10: a name of the block for searches and jumps, never an order. It stands first in the block;
// elsewhere some controls raise an alarm, so it is read with a warning. A second N of a block is an ordinary word that
// nothing uses. Between G10 L50 and G11 N is the number of a parameter, and nothing jumps there.
#include <isogloss/cnc/program_name.hpp>
#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct HeadIndexSyntax {
  static constexpr auto spec = ig::syntax("HeadIndexSyntax", "Reads the sequence number N.")
                                   .after("BlockSkipSyntax", "IsoCommentSyntax")
                                   .before("FlagSyntax", "WordSyntax")
                                   .scans("Nn")
                                   .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0114", "{0} is not at the start of its block: write the sequence number first"),
  };

  ig::Out<std::int64_t> n{"Source.N"};
  ig::Signal parameters{"ProgrammableDataInput.~Parameters", ig::read, ig::Life::modal};
  ig::Flow flow;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t digits = skip_blanks(text, position + 1);
    const std::size_t end = skip_digits(text, digits);
    if (end == digits || end - digits > 18 || b.is_fresh(n)) return position;
    std::int64_t number = 0;
    for (std::size_t i = digits; i < end; ++i) number = number * 10 + (text[i] - '0');
    b.set(n, number);
    if (flow.is_indexing() && !b.is_raised(parameters)) flow.label(b, NumberedName('N', number).text());
    if (position > 0 && !stands_first(text, position))
      b.report(ig::diag("ISO-0114"), ig::Where::columns(position, end), piece(text, position, end));
    return end;
  }
};

const ig::Register<HeadIndexSyntax> head_index_syntax;

}  // namespace
}  // namespace iso
