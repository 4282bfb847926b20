/// What a diagnostic means: `isogloss explain IG-0206`.
#pragma once

#include <string>

#include "session.hpp"

namespace isogloss::cli {

/// IG-0206: capitals and digits, a hyphen, digits.
bool is_code(std::string_view text);
int explain_code(const std::string& code, bool json, Session& session);

}  // namespace isogloss::cli
