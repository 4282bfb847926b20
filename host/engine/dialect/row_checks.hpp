/// What the rows of a table must be, wherever they come from.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isogloss.h"
#include "isogloss/engine/dialect.hpp"

namespace isogloss {

/// The value of the attribute that names the row; empty: there is none.
std::string_view key_of(const ig_dependency& dependency, const TableRow& row);

/// Of the rows of one element: elements, keys, columns and values that the table does not have, and keys that come
/// twice in one file.
std::vector<Diagnostic> check_rows(const ig_dependency& dependency, const std::string& owner,
                                   const std::vector<TableRow>& rows);

}  // namespace isogloss
