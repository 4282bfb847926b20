/// The arguments of a plugin's diagnostic as text.
#pragma once

#include <string>
#include <vector>

#include "isogloss.h"

namespace isogloss {

std::vector<std::string> argument_texts(const ig_argument* arguments, std::uint32_t count);

}  // namespace isogloss
