/// Two chains of which the second has other options, other ids of fields and other names than the first.
#pragma once

#include "validate/check.hpp"

namespace isogloss::cli {

void check_other_chains(Examination& e);

}  // namespace isogloss::cli
