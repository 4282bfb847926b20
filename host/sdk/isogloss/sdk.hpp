/// Everything that the author of a plugin includes.
#pragma once

#include "isogloss/block.hpp"
#include "isogloss/dependency.hpp"
#include "isogloss/diagnostics.hpp"
#include "isogloss/flow.hpp"
#include "isogloss/motion.hpp"
#include "isogloss/number.hpp"
#include "isogloss/plugin.hpp"
