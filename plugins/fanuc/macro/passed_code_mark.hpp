/// The last M code and the last sequence number of the blocks before, which #4113 and #4114 answer.
#pragma once

#include <optional>

#include <isogloss/sdk.hpp>

#include "macro/macro_store.hpp"

namespace fanuc {

using namespace ig::cnc;

/// A member of each syntax that notes or reads what #4113 and #4114 answer.
class PassedCodeMark {
 public:
  void note(ig::Block& b, MacroStore& store, char letter, double number) const {
    if (!b.is_raised(noted_here_)) store.passed.begin_block();
    b.raise(noted_here_);
    store.passed.note(letter == 'M' ? PassedCodes::m : PassedCodes::n, number);
  }
  std::optional<double> of_blocks_before(const ig::Block& b, const MacroStore& store, PassedCodes::Which which) const {
    return b.is_raised(noted_here_) ? store.passed.before(which) : store.passed.last(which);
  }

 private:
  ig::Signal noted_here_{"PassedCode.~NotedHere", ig::read | ig::write};
};

}  // namespace fanuc
