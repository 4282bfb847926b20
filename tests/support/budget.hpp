/// How many cases a random test runs: its own number, times what `./dev test --full` asks for.
#pragma once

#include <cstdlib>

namespace isogloss_test {

inline int budgeted(int cases) {
  const char* const factor = std::getenv("ISOGLOSS_TEST_BUDGET");
  return factor != nullptr ? cases * std::atoi(factor) : cases;
}

}  // namespace isogloss_test
