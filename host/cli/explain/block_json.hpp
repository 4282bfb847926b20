/// An explained block as JSON: schemas/explain.schema.json describes it.
#pragma once

#include "explain/block_text.hpp"

namespace isogloss::cli {

Json json_of(const ExplainedBlock& block, Amount amount, LineTexts& lines, std::span<const Diagnostic> reports = {});

}  // namespace isogloss::cli
