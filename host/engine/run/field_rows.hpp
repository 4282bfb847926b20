/// Text columns of the unit "fields": what their rows assign to fields of the block.
#pragma once

#include <string_view>
#include <vector>

#include "isogloss/engine/diagnostic.hpp"
#include "isogloss/engine/linker.hpp"

namespace isogloss {

/// What is wrong with `text`, "Coolant.Mode=FLOOD; Dwell.Time={P} s": fields that the dialect does not have, that no
/// syntax of the table may write or no one reads, values of another type, and other units. An assignment without a
/// field or a value is for the dependency to refuse.
std::vector<Diagnostic> check_field_rows(const LinkedDialect& linked, const LinkedDependency& dependency,
                                         std::string_view row, std::string_view text, const Location& where);

}  // namespace isogloss
