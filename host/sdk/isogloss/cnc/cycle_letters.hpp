/// What K, and J of a tapping cycle, mean. K is either a length (the third component of an arc's centre) or a count
/// (the repeats of a canned cycle). Inside the cycle's own block the code owns its K; in later blocks K stands alone,
/// and the modal state decides.
#pragma once

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// The meaning of K in a canned cycle: an option of each syntax that reads lengths.
class CycleK {
 public:
  bool is_length() const { return k_ == Meaning::length; }

 private:
  enum class Meaning { count, length };
  Choice<Meaning> k_{"cycle-k", "count|length", "count", "K of a canned cycle counts its repeats, or is a length."};
};

/// The meaning of J in a tapping cycle: an option of each syntax that reads lengths.
class TappingJ {
 public:
  static constexpr std::array<std::string_view, 2> cycles{"G74", "G84"};

  bool is_ratio() const { return j_ == Meaning::ratio; }
  /// True when J of this block, which stands without a code of its own, is a ratio: a tapping cycle is active.
  bool is_ratio(const Block& b) const { return is_ratio() && (b.is(cycle_, g74_) || b.is(cycle_, g84_)); }

 private:
  enum class Meaning { length, ratio };
  Choice<Meaning> j_{"tapping-j", "length|ratio", "length",
                     "J of G74 and G84 is a length, or how much faster the tap leaves."};
  In<Symbol> cycle_{"CannedCycle.Term"};
  Name g74_{"G74"}, g84_{"G84"};
};

}  // namespace ig::cnc
