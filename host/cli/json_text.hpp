/// JSON as the commands print it.
#pragma once

#include <string>

#include "catalogue.hpp"

namespace isogloss::cli {

/// "name: value" lines, for people.
std::string as_lines(const Json& object);
/// With line breaks and a line end; bytes that are no text are replaced.
std::string pretty(const Json& json);

}  // namespace isogloss::cli
