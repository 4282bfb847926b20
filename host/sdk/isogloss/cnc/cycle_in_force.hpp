/// Whether the words of a block are those of a canned cycle that an earlier block has called.
#pragma once

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// A member of each syntax that must tell a hole from a move: Z of a hole is its bottom, K the number of holes.
class CycleInForce {
 public:
  /// A canned cycle is active, and no code of the block ends it.
  bool is_on(const Block& b) const {
    return b.has(cycle_) && !b.is(cycle_, cancelled_) && !b.find(motions_) && !b.find(end_);
  }

 private:
  In<Symbol> cycle_{"CannedCycle.Term"};
  Codes motions_{{"G00", "G01", "G02", "G03", "G33"}, read};
  Codes end_{{"G80"}, read};
  Name cancelled_{"G80"};
};

}  // namespace ig::cnc
