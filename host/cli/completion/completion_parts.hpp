/// Names that are parts of what the line names: rows of its dialect's tables, headings of a page.
#pragma once

#include "catalogue.hpp"
#include "completion/completion.hpp"

namespace isogloss::cli {

/// TABLE., then TABLE.ROW. and TABLE.ROW.COLUMN= of the dialect or machine of the line, one level at a time.
std::vector<Completion> settings_of(const TypedLine& line, Session& session);
/// OPTION= of the importer that --format names, or of all; behind the sign, the values of a choice.
std::vector<Completion> importer_options_of(const TypedLine& line, Session& session);
/// Headings of the page of the first operand.
std::vector<Completion> headings_of(const TypedLine& line, Session& session);

}  // namespace isogloss::cli
