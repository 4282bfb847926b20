#include "cycles/hole_repeats.hpp"

#include <cmath>

namespace iso {

int HoleRepeats::read_count(ig::Block& b, const ig_field* words, const CycleWords& in) const {
  const bool by_k = word_ == RepeatWord::k_or_l && in.has(Address::K);
  const Address address = by_k ? Address::K : Address::L;
  if (!in.has(address)) return 1;
  const std::string_view letter = CycleBlock::letters.substr(address, 1);
  const ig_field field = words[address];
  if (by_k && in.has(Address::L)) b.report(ig::diag("ISO-0315"), ig::Where::word(words[Address::L]));
  const double k = in.get_or(address, 1);  // a count: units and increments are kept away from it
  if (!(k >= 0) || k != std::floor(k)) {
    b.report(ig::diag("ISO-0313"), ig::Where::word(field), letter, k);
    return 1;
  }
  const auto most = static_cast<double>(static_cast<std::int64_t>(most_));
  if (k > most) b.report(ig::diag("ISO-0314"), ig::Where::word(field), letter, k, most);
  return static_cast<int>(std::min(k, most));
}

void HoleRepeats::drop_count(ig::Block& b, const ig_field* words) const {
  if (!k_is_length()) CycleBlock::take(b, words[Address::K]);
  CycleBlock::take(b, words[Address::L]);
}

void HoleRepeats::keep_turns(ig::Block& b, const CycleBlock& block, int count) const {
  ig_value v[3];
  const std::uint32_t named = block.rotary_words(b, v);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((named >> axis & 1u) != 0) b.set(turn_[axis], v[axis].number);
  if (named != 0) b.set(repeats_, std::int64_t{count});
}

}  // namespace iso
