/// Words: X10, G1, CR=5, X=AC(10), X=R1*2, and assignments R1=5, NAME=3. Reads on over all words that follow each other
/// and hands them to the host in one call. Values are computed while the block is read, so that the syntaxes after this
/// one see plain words.
#include "language/word_reader.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensWord {
  static constexpr auto spec = ig::syntax("SiemensWordSyntax", "Words, codes and assignments of the Siemens language.")
                                   .after("HeadIndexSyntax")
                                   .before("ParameterizedFlagSyntax")
                                   .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$0123456789+-.,=")
                                   .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0115",
                     "'{0}' has no address before it, so nothing is executed for it: write its address"),
      ig::diagnostic(IG_ERROR, "SIE-0121", "'{0}' has no number: write its value, or remove the address"),
      ig::diagnostic(IG_WARNING, "SIE-0122",
                     "{0} stands more than once in this block, and the last one is used: remove the others"),
      ig::diagnostic(IG_ERROR, "SIE-0123",
                     "'{0}' is not a number, so the word is not executed: use one decimal point and no comma"),
      ig::diagnostic(IG_ERROR, "SIE-0125", "'{0}' is not a valid code and is not executed: check its number"),
      ig::diagnostic(IG_ERROR, "SIE-0127",
                     "'{0}' has no value, so nothing is assigned: write an equals sign and the value"),
      ig::diagnostic(IG_ERROR, "SIE-0128",
                     "{1} is not possible with {0}: the word is executed as if {1} were not there"),
      ig::diagnostic(IG_ERROR, "SIE-0131", "{0} with an index is not executed: write the address without an index"),
      ig::diagnostic(IG_WARNING, "SIE-0132", "T={0} is used as a tool name: write it in quotation marks"),
      ig::diagnostic(IG_WARNING, "SIE-0292",
                     "{0} moves the axis with the path of its block, not with a feed of its own"),
      ig::diagnostic(IG_ERROR, "SIE-0305",
                     "EXECSTRING is not executed with {0}: its text holds words and assignments of one block"),
      ig::diagnostic(IG_ERROR, "SIE-0320",
                     "CTABDEF in line {0} has no CTABEND, so nothing has moved since: write CTABEND after the curve"),
  };

  WordReader reader_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    return reader_.scan(b, text, position);
  }
};

const ig::Register<SiemensWord> siemens_word_syntax;

}  // namespace
}  // namespace siemens
