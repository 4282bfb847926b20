#include "../../tests/support/declarations.hpp"

TEST_CASE("no declaration depends on an option") { isogloss_test::check_declarations(*ig_plugin_v1()); }
