// The block number, and the skip sign / or /1 to /9 before or after it. The number is a name for people only: no jump
// uses it. While the operator has the skip switched on, the block is not executed.
#include <isogloss/cnc/block_skip.hpp>

#include "language/klartext_text.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextBlockNumber {
  static constexpr auto spec = ig::syntax("KlartextBlockNumberSyntax", "Reads the block number and the skip sign.")
                                   .scans("0123456789/Nn")
                                   .scans_ahead();

  BlockSkip skip_;
  ig::Out<std::int64_t> n_{"Source.N"};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (position != 0 && skip_blanks(text, 0) != position) return position;
    std::size_t i = position;
    if (text[i] == '/') {
      if (skips(b, text, i, true)) return text.size();
      i = skip_blanks(text, i);
    }
    const bool has_letter = to_upper(at(text, i)) == 'N' && is_digit(at(text, i + 1));
    i = skip_blanks(text, number_end(b, text, has_letter ? i + 1 : i));
    if (at(text, i) != '/') return i;
    return skips(b, text, i, false) ? text.size() : skip_blanks(text, i);
  }

 private:
  /// Sets the number that begins at `begin`, and says where it ends.
  std::size_t number_end(ig::Block& b, std::string_view text, std::size_t begin) const {
    const ig::Digits digits = ig::read_digits(text, begin);
    if (digits.ok) b.set(n_, static_cast<std::int64_t>(digits.value));
    return digits.end;
  }

  /// Takes the sign at `i`; true where the block is skipped.
  bool skips(ig::Block& b, std::string_view text, std::size_t& i, bool before_number) const {
    const std::size_t end = skip_sign_end(text, i, before_number);
    const std::size_t layer = end == i + 2 ? static_cast<std::size_t>(text[i + 1] - '0') : 1;
    i = end;
    return skip_.skip(b, layer, text.substr(i));
  }
};

const ig::Register<KlartextBlockNumber> klartext_block_number_syntax;

}  // namespace
}  // namespace heidenhain
