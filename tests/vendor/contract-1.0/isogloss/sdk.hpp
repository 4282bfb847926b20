/// All that a plugin author includes.
#pragma once

#include "isogloss/block.hpp"
#include "isogloss/dependency.hpp"
#include "isogloss/motion.hpp"
#include "isogloss/number.hpp"
#include "isogloss/plugin.hpp"
