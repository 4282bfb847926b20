/// The canned cycle of a block: which cycle is on, and the codes and words of its call as programmed. The words are
/// with their code (Parsing.G81.X), or alone (Parsing.X) in a block of a cycle that is on. Raises no diagnostic.
#pragma once

#include <isogloss/cnc/canned_cycle.hpp>

namespace iso {

using namespace ig::cnc;

/// The cycle that is on in a block, if any.
struct ActiveCycle {
  std::optional<std::size_t> cycle;   ///< row of CycleBlock::calls()
  bool is_called = false;             ///< by its code in this block, whose words are in Parsing.Gxx
  bool is_entry = false;              ///< the mode was off before
  bool changed = false;               ///< the block was written to find this out
  std::optional<std::size_t> before;  ///< the cycle that was on, if one is called in this block
};

class CycleBlock {
 public:
  /// The words that may be alone, in the order of cycle_words; F alone is FeedrateSyntax's.
  static constexpr std::string_view letters = "XYZRQPIJKL";

  CycleBlock();

  const CycleCalls& calls() const { return calls_; }
  ig::Symbol name(const ActiveCycle& now) const { return calls_.name(*now.cycle); }
  std::optional<std::size_t> row_of(ig::Symbol cycle) const;
  /// Where the cycle words of this block are: a field for each of `letters`, and F where the code is in the block.
  const ig_field* words(const ActiveCycle& now) const { return now.is_called ? calls_.row(*now.cycle) : alone_.data(); }

  /// The words that this block holds of `letters`, as programmed.
  CycleWords given(const ig::Block& b, const ActiveCycle& now) const {
    CycleWords out;
    out.mask = b.get_many(words(now), letters.size(), out.values.data());
    return out;
  }
  /// A block drills when it names a position; M, S, T and F alone do not, nor do the words of G31, G53 and G60.
  bool is_hole(const ig::Block& b, const ActiveCycle& now, const CycleWords& in) const {
    constexpr std::uint32_t x_y_z_r = 0b1111;
    ig_value unused[3];
    if ((in.mask & x_y_z_r) == 0 && rotary_words(b, unused) == 0) return false;
    return now.is_called || !b.find(one_shot_);
  }
  /// The values of A, B and C, with a bit for each that the block holds: axes that are positioned before the hole, and
  /// not the resolver's to take.
  std::uint32_t rotary_words(const ig::Block& b, ig_value* values) const {
    return b.get_many(rotary_.data(), rotary_.size(), values);
  }

  static std::optional<double> take(ig::Block& b, ig_field word) {
    ig_value v;
    if (!b.take(word, v)) return std::nullopt;
    return v.number;
  }
  /// Takes the F of the call in row `row`, and puts it in force.
  void take_feed(ig::Block& b, std::size_t row) const;
  /// Removes the cycle codes: to the syntax of a cycle a call without words is a hole where the tool stands.
  void erase_codes(ig::Block& b) const;
  /// A motion code follows the cycle code: it moves the axes and F is its feed; nothing uses the other words.
  void give_back(ig::Block& b, std::size_t row) const;
  /// Takes the words of a block that drills nothing, and removes the code.
  void swallow(ig::Block& b, const ActiveCycle& now) const {
    std::array<ig_value, letters.size()> values;
    b.take_many(words(now), letters.size(), values.data());
    if (!now.is_called) return;
    erase_codes(b);
    take_feed(b, *now.cycle);
  }

 private:
  static ig_field rotary_word(const char* path) {
    return ig::Field<double>(path, ig::read, {ig::Life::standard, "deg", ""}).id();
  }

  CycleCalls calls_{cycle_words, ig::take | ig::wake | ig::write};
  std::array<ig_field, letters.size()> alone_{};
  // Codes that have the axis words of their block for themselves.
  ig::Codes one_shot_{{"G31", "G53", "G60"}, ig::read};
  std::array<ig_field, 3> rotary_{rotary_word("Parsing.A"), rotary_word("Parsing.B"), rotary_word("Parsing.C")};
  FeedInForce feed_{ig::read | ig::write};
};

}  // namespace iso
