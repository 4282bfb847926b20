/// An explained block as text: the sentence, the words, the way to the machine, and what the block changed.
#pragma once

#include "explain/facts.hpp"

namespace isogloss::cli {

enum class Amount {
  sentence,  ///< --brief
  changes,
  all  ///< --all: every carried value, every syntax that was called or slept
};

std::string text_of(const ExplainedBlock& block, Amount amount, LineTexts& lines);

}  // namespace isogloss::cli
