/// Group 09, which cycle is on in a block: a cycle code begins a cycle, G80 and the motion codes of group 01 end it,
/// and the last code of the block wins. Reports a cycle code beside a motion code (ISO-0310).
#pragma once

#include "cycles/cycle_data.hpp"

namespace iso {

class CycleMode {
 public:
  /// Takes G80; ends and forgets a cycle that this block cancels; gives the words of a call that a motion code follows
  /// back to the block.
  ActiveCycle enter_or_cancel(ig::Block& b, const CycleBlock& block, const CycleData& data) const;

 private:
  ig::Codes g80_{"G80"};
  ig::Codes group01_{{"G00", "G01", "G02", "G03", "G33"}, ig::read};
};

}  // namespace iso
