/// The last M code and the last sequence number of the blocks before, which #4113 and #4114 answer.
#pragma once

#include <optional>

#include <isogloss/sdk.hpp>

#include "macro/macro_store.hpp"

namespace fanuc {

using namespace ig::cnc;

/// A member of the syntax that keeps them, and of those that read what is kept.
class PassedCodeMark {
 public:
  explicit PassedCodeMark(ig::Access access = ig::read) : kept_here_("PassedCode.~KeptHere", access) {}
  /// Those of this block, where it has them.
  void keep(ig::Block& b, MacroStore& store, std::optional<double> m, std::optional<double> n) const {
    store.passed.begin_block();
    if (m) store.passed.note(PassedCodes::m, *m);
    if (n) store.passed.note(PassedCodes::n, *n);
    b.raise(kept_here_);
  }
  std::optional<double> of_blocks_before(const ig::Block& b, const MacroStore& store, PassedCodes::Which which) const {
    return b.is_raised(kept_here_) ? store.passed.before(which) : store.passed.last(which);
  }

 private:
  ig::Signal kept_here_;
};

}  // namespace fanuc
