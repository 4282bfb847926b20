#include <catch2/catch.hpp>

#include "../../../tests/support/fake_dependency.hpp"

using namespace isogloss_test;
using Catch::Matchers::Contains;

namespace {

FakeDependency with(const char* name, double value) {
  return FakeDependency(*ig_plugin_v1(), "SyntecVariables", {{name, {{"Value", value}}}}, {});
}

}  // namespace

TEST_CASE("registers and integers of the control have rows with integers of 32 bits") {
  CHECK_NOTHROW(with("R5", -2147483648.0));
  CHECK_NOTHROW(with("@100005", 2147483647));
  CHECK_NOTHROW(with("#1100", 2.5));
  for (const char* const name : {"R5", "@100005", "#1080"})
    for (const double value : {2.5, 2147483648.0, -2147483649.0})
      CHECK_THROWS_WITH(with(name, value), Contains(name) && Contains("an integer of 32 bits"));
}

TEST_CASE("local variables have no rows") { CHECK_THROWS_WITH(with("#1", 5), Contains("#1") && Contains("local")); }
