/// An explained block as text: the sentence, the words, the way to the machine, and what the block changed.
#pragma once

#include "explain/facts.hpp"

namespace isogloss::cli {

enum class Amount {
  sentence,  ///< --brief
  changes,
  all  ///< --all: every carried value, every syntax that was called or slept
};

/// `reports`: what the run has reported, for the lines that are explained at least.
std::string text_of(const ExplainedBlock& block, Amount amount, LineTexts& lines,
                    std::span<const Diagnostic> reports = {});

}  // namespace isogloss::cli
