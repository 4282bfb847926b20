/// How many cases a random test runs: its own number, times ISOGLOSS_TEST_BUDGET. `./dev test --random` asks for more,
/// the sanitizers of `./dev test` for less.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace isogloss_test {

inline int budgeted(int cases) {
  const char* const factor = std::getenv("ISOGLOSS_TEST_BUDGET");
  return factor != nullptr ? std::max(1, static_cast<int>(std::lround(cases * std::atof(factor)))) : cases;
}

}  // namespace isogloss_test
