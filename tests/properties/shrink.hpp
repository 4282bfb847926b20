/// Makes a program that shows a fault as short as it gets.
#pragma once

#include "property.hpp"

namespace isogloss::properties {

/// Takes lines away, then words of lines, as long as the property does not hold.
Case shrink(const Property& property, Case program);

}  // namespace isogloss::properties
