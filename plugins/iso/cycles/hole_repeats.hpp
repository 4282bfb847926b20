/// The holes of one block: how many K or L asks for, and the way from hole to hole, in mm and, for rotary axes,
/// degrees. Reports a count that is none (ISO-0313) or too large (ISO-0314), and K beside L (ISO-0315).
#pragma once

#include <span>

#include "cycles/cycle_data.hpp"

namespace iso {

class HoleRepeats {
 public:
  using Address = CycleWords::Address;

  /// True where L alone is the number of holes and K a length of the cycle.
  bool k_is_length() const { return word_ == RepeatWord::l; }
  /// The words of CycleData::words that are kept: K only where it is a length.
  std::span<const Address> kept_words() const {
    return std::span(CycleData::words).first(CycleData::words.size() - (k_is_length() ? 0 : 1));
  }

  /// K, or L where there is no K; `words` are the fields of `in`. 0: keep the data, drill nothing.
  int count(ig::Block& b, const ig_field* words, const CycleWords& in) const {
    return in.has(Address::K) || in.has(Address::L) ? read_count(b, words, in) : 1;
  }
  /// Takes the counts of a block that calls a cycle and drills nothing; a K that is a length stays, to be reported.
  void drop_count(ig::Block& b, const ig_field* words) const;
  /// Under G91 the rotary words of the block turn their axes before each hole; McAbcSyntax does.
  void keep_turns(ig::Block& b, const CycleBlock& block, int count) const;
  /// From hole to hole: of a pattern (HolePatternSyntax) where the block has one, else `step`.
  ig::Vec3 step(const ig::Block& b, const ig::Vec3& step) const { return b.get(pattern_).or_else(step); }

  /// Writes the number of holes into the resolved call, whose fields are `row`: as K, or as L where K is a length.
  /// `in` are the words of the block; `put` sets one word of the call.
  template <class Put>
  void put_count(ig::Block& b, const ig_field* row, const CycleWords& in, int count, const Put& put) const {
    if (count == 1 && !k_is_length() && !in.has(Address::K) && !in.has(Address::L)) return;
    ig_value unused;
    const bool has_length = k_is_length() && b.get(row[Address::K], unused);
    const Address counter = k_is_length() ? Address::L : Address::K;
    const Address other = counter == Address::L ? Address::K : Address::L;
    if (!has_length) CycleBlock::take(b, row[other]);
    if (count == 1 && !has_length)
      CycleBlock::take(b, row[counter]);
    else
      put(counter, count);
  }
  void put_step(ig::Block& b, const ig::Vec3& step) const {
    if (step != ig::Vec3{}) b.set(increment_, step);
  }

 private:
  int read_count(ig::Block& b, const ig_field* words, const CycleWords& in) const;

  enum class RepeatWord { k_or_l, l };
  static constexpr ig::About turn{ig::Life::block, "deg", "From hole to hole of a repeat."};

  ig::Xyz increment_{"CannedCycle.Increment", ig::write, {ig::Life::block, "mm", "From hole to hole of a repeat."}};
  std::array<ig::Out<double>, 3> turn_{ig::Out<double>{"CannedCycle.Increment.A", turn},
                                       ig::Out<double>{"CannedCycle.Increment.B", turn},
                                       ig::Out<double>{"CannedCycle.Increment.C", turn}};
  ig::Out<std::int64_t> repeats_{"CannedCycle.Repeats",
                                 {ig::Life::block, "", "Holes of a repeat that turns rotary axes."}};
  ig::Xyz pattern_{"HolePattern.Step", ig::read};
  ig::IntegerOption most_{"max-repeats", "10000", {1, most_repeats}, "Holes that one block may drill by K or L."};
  ig::Choice<RepeatWord> word_{"repeat-word", "k-or-l|l", "k-or-l",
                               "The word that counts the holes of a block: K, or L where K is missing; or L "
                               "alone, if K is a length of the cycle."};
};

}  // namespace iso
